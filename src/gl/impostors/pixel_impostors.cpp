#include "gl/impostors/pixel_impostors.h"

#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

/// Reads the point size. Points must be squares of the set size, with point coordinates from the upper left.
Reason readPointSize(ShadowState& shadow) {
  const RealGl& real = shadow.real;
  const bool core = shadow.info.core;
  // gl_PointSize is known only where the family names its value.
  const bool ofProgram = isOn(real, GL_PROGRAM_POINT_SIZE);
  if (ofProgram && !(shadow.program().pixelSize > 0)) return Reason::points;
  if (!core && (isOn(real, GL_POINT_SMOOTH) || !isOn(real, GL_POINT_SPRITE))) return Reason::points;
  if (integer(real, GL_POINT_SPRITE_COORD_ORIGIN) != GL_UPPER_LEFT) return Reason::points;
  GLfloat size = 1, range[2] = {1, 1};
  real.GetFloatv(GL_POINT_SIZE, &size);
  if (ofProgram) size = shadow.program().pixelSize;
  real.GetFloatv(core ? GL_POINT_SIZE_RANGE : GL_ALIASED_POINT_SIZE_RANGE, range);
  size = std::clamp(size, range[0], range[1]);
  const glm::ivec4& viewport = shadow.viewport().box;
  shadow.setImpostorSize(glm::vec2(2 * size) / glm::vec2(viewport.z, viewport.w));
  return Reason::traced;
}

/// Whether the program's depth for impostors is that of round shapes under its projection.
bool depthFits(const ProgramState& program) {
  const scene::Impostors& f = program.impostors;
  const glm::dmat4 rows = glm::transpose(program.clipFromObject);
  const glm::dvec3 z(rows[2]), w(rows[3]);
  const bool parallel = w == glm::dvec3(0);
  if (parallel != f.parallelView || !(f.bulge >= 0 && f.bulge < 0.4f) || !(f.depthBias <= 0)) return false;
  if (parallel || f.bulge == 0) return std::isfinite(f.bulgeDepth);
  // The window depth at infinity: the bulge must not change it.
  constexpr double kRounding = 1e-4;
  const double end = 0.5 * (glm::dot(z, w) / glm::dot(w, w)) + 0.5;
  return std::abs(end - f.bulgeDepth) <= kRounding * std::abs(end);
}

/// Splats may be offset only by a depth bias towards the viewer. Their billboards have constant depth, so
/// that a polygon offset would use no slope.
Reason checkSplats(const ProgramState& program, const RasterState& raster) {
  const scene::Impostors& f = program.impostors;
  const glm::dmat4 rows = glm::transpose(program.clipFromObject);
  const bool parallel = glm::dvec3(rows[3]) == glm::dvec3(0);
  const bool sane = f.size.x != 0 && f.size.y != 0 && std::isfinite(f.size.x + f.size.y);
  return parallel == f.parallelView && sane && f.depthBias <= 0 && !raster.offsetFill ? Reason::traced
                                                                                      : Reason::program;
}

/// Sets the size of tubes whose width is a number of pixels. Lines that are not wider than one are no tubes.
Reason readLineWidth(ShadowState& shadow) {
  const ProgramState& program = shadow.program();
  const glm::vec4 box(shadow.viewport().box);
  if (!(program.pixelSize > 1)) return Reason::lines;
  if (program.usedViewport != box) {
    shadow.setProgramWhy("the viewport that it computes tubes with is not the viewport");
    return Reason::programValue;
  }
  shadow.setImpostorSize(glm::vec2(2 * program.pixelSize) / glm::vec2(box.z, box.w));
  return Reason::traced;
}

}  // namespace

Reason readPixelImpostors(ShadowState& shadow) {
  const ViewportState& viewport = shadow.viewport();
  const ProgramState& program = shadow.program();
  const scene::Shape shape = shadow.attributes().shape;
  if (viewport.depthNear != 0 || viewport.depthFar != 1) return Reason::program;
  if (shape == scene::Shape::splats) return checkSplats(program, shadow.raster());
  if (!depthFits(program)) return Reason::program;
  if (shape == scene::Shape::beads) return readPointSize(shadow);
  if (program.impostors.inPixels)
    if (const Reason reason = readLineWidth(shadow); reason != Reason::traced) return reason;
  const glm::vec2 size = program.impostors.size;
  if (!(size.x > 0 && size.y > 0) || !std::isfinite(size.x + size.y)) return Reason::program;
  return shadow.raster().offsetFill ? Reason::program : Reason::traced;
}

}  // namespace gluray::gl
