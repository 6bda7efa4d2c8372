// ProgramReader: uniforms of impostors whose billboards the program sends.
#include "gl/program_state/program_reader.h"

#include <cmath>

namespace gluray::gl {
namespace {

/// Whether depth depends only on z, and the viewer is where the program assumes it: at the origin or, if
/// `parallel`, at infinity along +z.
bool isProjectionFrom(const glm::mat4& m, bool parallel) {
  const glm::mat4 rows = glm::transpose(m);
  if (rows[2].x != 0 || rows[2].y != 0 || rows[3].x != 0 || rows[3].y != 0) return false;
  if (parallel) return rows[3].z == 0 && rows[3].w == 1 && rows[0].z == 0 && rows[1].z == 0;
  return rows[3].z == -1 && rows[3].w == 0 && rows[0].w == 0 && rows[1].w == 0;
}

/// Whether the matrix consists of a rotation, a translation and a uniform scale, and `normals` is its inverse
/// transpose.
bool isSimilar(const glm::dmat4& matrix, const glm::mat3& normals) {
  constexpr double kRounding = 1e-4;
  const glm::dmat3 m(matrix), product = glm::transpose(m) * m,
                              turned = glm::transpose(m) * glm::dmat3(normals);
  const double squared = product[0][0];
  if (!(squared > 0)) return false;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      const double one = c == r ? 1 : 0;
      if (!(std::abs(product[c][r] / squared - one) < kRounding)) return false;
      if (!(std::abs(turned[c][r] - one) < kRounding)) return false;
    }
  return true;
}

}  // namespace

Reason ProgramReader::readSentBillboards() {
  const FamilyImpostors& f = family_.impostors;
  const glm::mat4 projection = uniforms_.matrix4(f.projection);
  if (!out_.eyeFromObject) return Reason::program;
  const bool parallel = f.hemispheres ? isProjectionFrom(projection, true) : f.parallelView;
  out_.impostors.parallelView = parallel, out_.impostors.hemispheres = f.hemispheres;
  out_.shading.fragment.parallelView = parallel;
  if (!isProjectionFrom(projection, parallel))
    return refuse("matrix \"" + f.projection + "\" is not a projection from where the family has the viewer");
  float scale = uniforms_.number(f.scale, 1);
  if (scale == 0 && f.zeroScaleIsOne) scale = 1;
  const float perObject = f.radiusInObject ? glm::length(out_.normalMatrix[0]) : 1.0f;
  if (!(scale > 0 && perObject > 0) || !std::isfinite(perObject / scale))
    return refuse("the scale of radii is not above 0");
  out_.impostors.radiusDivisor = perObject / scale;
  if (f.shape != scene::Shape::sticks) return Reason::traced;
  if (!isSimilar(*out_.eyeFromObject, out_.normalMatrix))
    return refuse("its matrices stretch cylinders or skew them");
  out_.impostors.roundEnds = f.roundCaps.empty() || uniforms_.integer(f.roundCaps) != 0;
  out_.impostors.halvesBlend = f.halvesBlend.empty() ? 0.0f : 1.0f;
  for (const FamilyValue& factor : f.halvesBlend) out_.impostors.halvesBlend *= uniforms_.number(factor, 0);
  out_.impostorCaps = current(f.caps).x;
  return Reason::traced;
}

}  // namespace gluray::gl
