// ProgramReader: matrices, the viewer and the window.
#include "gl/basics/affine.h"
#include "gl/program_state/program_reader.h"
#include "gl/programs/program_functions.h"
#include "gl/real/clip_depths.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

bool hasFunction(const std::vector<std::string>& names) {
  return std::ranges::any_of(names, [](const std::string& name) { return name.starts_with('$'); });
}

/// Divides an affine matrix by its factor; false if it is not affine.
bool makeAffine(glm::dmat4& m) {
  const glm::dvec4 last = glm::row(m, 3);
  if (last.w == 0 || glm::dvec3(last) != glm::dvec3(0)) return false;
  m /= last.w;
  return true;
}

/// Whether matrices are the same up to a factor, and to how far floats round chains of them.
bool areAlike(const glm::dmat4& a, const glm::dmat4& b) {
  constexpr double kRounding = 1e-3;
  const double factor = a[3][3] / b[3][3];
  double most = 0, apart = 0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) {
      most = std::max(most, std::abs(a[c][r]));
      apart = std::max(apart, std::abs(a[c][r] - factor * b[c][r]));
    }
  return apart <= kRounding * most;  // false for NaN
}

/// Whether all points of a line through `from` are at one place of the window.
bool isLineOfSight(const glm::dmat4& clipFromEye, const glm::dvec4& from) {
  constexpr double kRounding = 1e-4;
  return std::ranges::all_of(std::initializer_list<int>{0, 1, 3}, [&](int row) {
    const glm::dvec4 terms = glm::row(clipFromEye, row) * from;
    const double sum = terms.x + terms.y + terms.z + terms.w;
    return std::abs(sum) <=
           kRounding * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w));
  });
}

/// A rotation of `direction` to +z.
glm::dmat3 turnToZ(const glm::dvec3& direction) {
  const glm::dvec3 z = glm::normalize(direction);
  const glm::dvec3 x =
      glm::normalize(glm::cross(std::abs(z.y) < 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), z));
  return glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
}

}  // namespace

Reason ProgramReader::readTransform() {
  const auto clip = productOf(*out_.known, uniforms_, family_.clipFromObject);
  if (!clip) return refuse("a function of its positions is not understood");
  out_.clipFromObject = hasDepthsFromZero(real_, has_) ? toUsualDepths(*clip) : *clip;
  out_.eyeFromObject = productOf(*out_.known, uniforms_, family_.eyeFromObject);
  if (hasFunction(family_.eyeFromObject) && !(out_.eyeFromObject && makeAffine(*out_.eyeFromObject)))
    return refuse("the function to the space of its lights is not understood");
  // Lights may be given in another space than eye space, such as world space: moves the origin to the viewer.
  viewer_ = glm::vec3(uniforms_.vector(family_.viewer));
  if (out_.eyeFromObject) out_.eyeFromObject = glm::translate(glm::dmat4(1), -viewer_) * *out_.eyeFromObject;
  if (hasFunction({family_.normalMatrix})) {
    auto matrix = matrixOf(*out_.known, uniforms_, family_.normalMatrix);
    if (!matrix || !makeAffine(*matrix)) return refuse("the function of its normals is not understood");
    out_.normalMatrix = glm::mat3(*matrix);
  } else if (uniforms_.has(family_.normalMatrix)) {
    out_.normalMatrix = uniforms_.matrix3(family_.normalMatrix);
  } else if (out_.eyeFromObject) {
    out_.normalMatrix = glm::mat3(glm::transpose(glm::inverse(glm::dmat3(*out_.eyeFromObject))));
  } else {
    out_.normalMatrix = glm::mat3(1);
  }
  return readSight();
}

Reason ProgramReader::readSight() {
  if (family_.linesOfSight.empty() && family_.eyeAgain.empty() && !family_.derivedNormals)
    return Reason::traced;
  if (!out_.eyeFromObject || !isInvertible(*out_.eyeFromObject)) return Reason::singularMatrix;
  const auto again = productOf(*out_.known, uniforms_, family_.eyeAgain);
  if (!family_.eyeAgain.empty() && !(again && areAlike(*out_.eyeFromObject, *again)))
    return refuse("its transforms are not the inverse of each other");
  const glm::dmat4 clipFromEye = out_.clipFromObject * glm::inverse(*out_.eyeFromObject);
  if (family_.derivedNormals && glm::determinant(clipFromEye) > 0)
    return refuse("its normals are those of a mirror image");
  if (family_.linesOfSight.empty()) return Reason::traced;
  const auto sight = matrixOf(*out_.known, uniforms_, family_.linesOfSight);
  const glm::dvec4 viewer = sight ? (*sight)[2] : glm::dvec4(0);
  if (!(glm::length(viewer) > 0) || !isLineOfSight(clipFromEye, viewer))
    return refuse("its lines of sight are not those of its positions");
  constexpr double kFarthest = 1e12;
  const bool infinite = std::abs(viewer.w) * kFarthest <= glm::length(glm::dvec3(viewer));
  // Depths grow away from the viewer.
  if (infinite ? !((*sight)[3].w > 0) : !(viewer.w < 0)) return refuse("its depths grow towards the viewer");
  placeViewer(infinite ? glm::dvec4(-glm::dvec3(viewer), 0) : viewer / viewer.w);
  return Reason::traced;
}

void ProgramReader::placeViewer(const glm::dvec4& toViewer) {
  seenFromInfinity_ = toViewer.w == 0;
  if (seenFromInfinity_) {
    turn_ = turnToZ(glm::dvec3(toViewer));
    out_.eyeFromObject = glm::dmat4(turn_) * *out_.eyeFromObject;
    out_.normalMatrix = glm::mat3(turn_ * glm::dmat3(out_.normalMatrix));
  } else {
    viewer_ = glm::dvec3(toViewer);
    out_.eyeFromObject = glm::translate(glm::dmat4(1), -viewer_) * *out_.eyeFromObject;
  }
}

void ProgramReader::turnLights() {
  for (scene::FragmentLight& light : out_.shading.fragment.lights) {
    if (seenFromInfinity_) light.direction = glm::vec3(turn_ * glm::dvec3(light.direction));
    if (family_.lights.highlightsNeedShininess && light.ownHighlight && !(light.shininess > 0))
      light.highlight = glm::vec3(0);
  }
}

Reason ProgramReader::readWindow() {
  out_.window.reset();
  if (!uniforms_.has(family_.clipWindow)) return Reason::traced;
  const auto pixels = matrixOf(*out_.known, uniforms_, family_.windowFromPixels);
  if (!pixels || *pixels != glm::dmat4(1)) return refuse("its window is not that of pixels");
  const glm::vec4 sides = uniforms_.vector(family_.clipWindow);
  constexpr float kMost = 1e6f;
  // Centres of pixels count.
  const auto first = [&](float from) {
    return static_cast<int>(std::ceil(std::clamp(from, 0.0f, kMost) - 0.5f));
  };
  const auto end = [&](float to) { return static_cast<int>(std::floor(std::clamp(to, 0.0f, kMost) + 0.5f)); };
  scene::Region& window = out_.window.emplace();
  window.x = first(sides.x), window.width = std::max(0, end(sides.y) - window.x);
  window.y = first(sides.z), window.height = std::max(0, end(sides.w) - window.y);
  return Reason::traced;
}

}  // namespace gluray::gl
