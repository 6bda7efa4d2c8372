// Extent in space of impostors with a size in pixels: bounds that hold for every rotation of the camera.
#include "accel/impostors/impostor_reach.h"
#include "scene/box_corner.h"

#include <algorithm>
#include <cmath>

namespace gluray::accel {
namespace {

/// Bounds of an instance's vertices relative to the viewer that hold for every rotation.
struct Range {
  glm::dmat4 lightingFromObject, clipFromLighting, lightingFromClip, rows;  // rows: of clipFromLighting
  glm::dvec3 middle{0};
  double radius = 0;    // of the sphere about `middle` that holds all vertices, lighting space
  double farthest = 0;  // clip w
  double depthScale = 0.5;

  Range(const scene::Instance& instance, const scene::Camera& camera)
      : lightingFromObject(instance.lightingFromObject),
        clipFromLighting(camera.clipFromEye * instance.eyeFromObject * glm::inverse(lightingFromObject)),
        lightingFromClip(glm::inverse(clipFromLighting)),
        rows(glm::transpose(clipFromLighting)),
        depthScale(0.5 * std::abs(double{camera.depthFar} - camera.depthNear)) {
    const scene::Mesh& mesh = *instance.mesh;
    middle = glm::dvec3(lightingFromObject * glm::dvec4(0.5f * (mesh.lower + mesh.upper), 1));
    for (int i = 0; i < 8; ++i) {
      const glm::dvec4 corner(scene::boxCorner(mesh.lower, mesh.upper, i), 1);
      radius = std::max(radius, glm::distance(middle, glm::dvec3(lightingFromObject * corner)));
    }
    farthest = std::abs(glm::dot(rows[3], glm::dvec4(middle, 1))) + glm::length(glm::dvec3(rows[3])) * radius;
  }
  glm::dvec3 z() const { return glm::dvec3(lightingFromClip[2]); }
  /// Upper bound of the distance from the viewer.
  double away() const { return glm::distance(middle, z() / lightingFromClip[2].w) + radius; }
  /// Upper bound of the distance that a window depth bias moves a point.
  double movedBy(float bias, bool parallel) const {
    if (parallel) return std::abs(bias) / depthScale * glm::length(z());
    const glm::dvec3 depthRow(rows[2]), wRow(rows[3]);
    const double a = glm::dot(depthRow, wRow) / glm::dot(wRow, wRow);
    const double b = rows[2].w - a * rows[3].w;  // NDC depth is a + b/w
    return away() * farthest * std::abs(bias) / (depthScale * std::max(std::abs(b), 1e-30));
  }
};

/// Rounds up to quarter octaves: an approaching camera causes a rebuild only at each step, rotations none.
double inSteps(double reach) {
  constexpr double kStepsAnOctave = 4;
  return std::exp2(std::ceil(std::log2(reach * (1 + 1e-3)) * kStepsAnOctave) / kStepsAnOctave);
}

/// Extent of |M p| <= 1 along each axis: the lengths of the rows of M's inverse.
glm::dvec3 perUnit(const glm::dmat4& lightingFromObject) {
  const glm::dmat3 rows = glm::transpose(glm::inverse(glm::dmat3(lightingFromObject)));
  return {glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])};
}

}  // namespace

double largestStretch(const glm::dmat3& m) {
  const glm::dvec3 squares(glm::dot(m[0], m[0]), glm::dot(m[1], m[1]), glm::dot(m[2], m[2]));
  const double largest = std::max({squares.x, squares.y, squares.z});
  const double across = std::max(
      {std::abs(glm::dot(m[0], m[1])), std::abs(glm::dot(m[0], m[2])), std::abs(glm::dot(m[1], m[2]))});
  // Gershgorin's theorem for M^T M.
  return std::sqrt(largest + 2 * across);
}

ImpostorReach reachOfSplats(const scene::Instance& instance, const scene::Camera& camera) {
  const scene::Impostors& f = instance.impostors;
  const Range range(instance, camera);
  // Away from the window's middle, an extent along the view direction also shifts the projection sideways: in
  // the centre's plane by the tangent of the angle from the middle.
  constexpr double kFarthest = 1.3;
  const glm::dvec2 tangents = kFarthest / glm::abs(glm::dvec2(f.size));
  const double slanted = f.parallelView ? 1 : std::sqrt(1 + glm::dot(tangents, tangents));
  // The billboard's corners; shaders round its sides.
  const double corners = f.fillsBillboard() ? std::sqrt(2.0) * double{f.billboardScale} * (1 + 1e-3) : 1.0;
  const double reach = largestStretch(glm::dmat3(range.lightingFromObject)) * slanted * corners /
                       double{f.radiusDivisor} * (1 + 1e-4);
  // No eigenvalue is above the trace; depths do not count, as those of the billboard are its centre's.
  const double wider = std::sqrt(double{f.lowpass.x} + f.lowpass.z) * corners * range.farthest *
                       std::max(1 / std::abs(double{f.size.x}), 1 / std::abs(double{f.size.y}));
  const double further = wider + (f.depthBias != 0 ? range.movedBy(f.depthBias, f.parallelView) : 0.0);
  const glm::dvec3 unit = perUnit(range.lightingFromObject);
  ImpostorReach result;
  for (int c = 0; c < 3; ++c) {
    result.perRadius[c] = roundedUp(unit[c] * reach);
    if (further > 0) result.further[c] = roundedUp(unit[c] * inSteps(further));
  }
  return result;
}

ImpostorReach reachInPixels(const scene::Instance& instance, const scene::Camera& camera) {
  const scene::Impostors& f = instance.impostors;
  const bool tubes = instance.mesh->shape == scene::Shape::tubes;
  const Range range(instance, camera);
  const glm::dmat4& lightingFromClip = range.lightingFromClip;
  const double farthest = range.farthest;
  // In the window: half a billboard, plus the growth at the ends of lines.
  const glm::dvec2 size(f.size);
  const glm::dvec2 unit(glm::length(glm::dvec3(lightingFromClip[0])),
                        glm::length(glm::dvec3(lightingFromClip[1])));
  const double aside = farthest * std::max(unit.x * size.x, unit.y * size.y) * 0.5;
  // Tubes in pixels are wider than one.
  const double growth = (f.grows ? 0.25 : 0.0) + (f.inPixels ? double{f.longer} : 0.0);
  const double grown = farthest * std::max(unit.x, unit.y) * glm::length(size) * growth;
  // Towards the viewer: largest at the middle of the billboard.
  const double bulge = (tubes ? 2 : 1) * double{f.bulge};
  const double out = f.parallelView
                         ? std::abs(bulge * f.bulgeDepth) / range.depthScale * glm::length(range.z())
                         : bulge * range.away();
  const double moved = range.movedBy(f.depthBias, f.parallelView);
  const double reach = inSteps(std::max(aside, out) + 0.05 * std::min(aside, out) + grown + moved);
  const glm::dvec3 unit3 = perUnit(range.lightingFromObject);
  ImpostorReach result;
  for (int c = 0; c < 3; ++c) result.perRadius[c] = roundedUp(unit3[c] * reach);
  return result;
}

}  // namespace gluray::accel
