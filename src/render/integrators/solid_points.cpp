#include "render/integrators/solid_points.h"

#include "accel/impostors/solid.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace gluray::render {
namespace {

struct Point {
  glm::dvec3 point, normal;
};

/// A line of sight: unit direction away from the viewer.
struct LineOfSight {
  glm::dvec3 org, dir;
};

/// The spaces of one instance's impostors. Points and directions are in lighting space.
struct Spaces {
  glm::dmat4 eyeFromLighting, objectFromLighting;
  explicit Spaces(const accel::PlacedImpostors& placed)
      : eyeFromLighting(glm::inverse(glm::dmat4(placed.lightingFromEye))),
        objectFromLighting(glm::inverse(glm::dmat4(placed.lightingFromObject))) {}
};

/// The line of sight through a window position.
LineOfSight sightThrough(const ImpostorSpace& space, double x, double y) {
  const glm::dvec4 start = space.start + x * space.startX + y * space.startY;
  const glm::dvec3 org = glm::dvec3(start) / start.w;
  return {org, glm::normalize(glm::dvec3(space.step) - space.step.w * org)};
}

/// The point of an impostor that a line of sight meets. `computed`: what its program computed, whose point
/// lies on the impostor's axis or, of half spheres, near the solid. The program may draw pixels at the
/// silhouette beside the solid: their points are as far away as the axis, and have the program's normal.
Point seenAlong(const LineOfSight& sight, const accel::PlacedImpostors& placed, const Spaces& spaces,
                uint32_t primitive, double thickest, const Point& computed) {
  const double axis = glm::dot(computed.point - sight.org, sight.dir);
  // The ray starts in front of the axis, farther than any impostor is thick.
  const double before = axis - thickest;
  const glm::dmat3 linear(spaces.objectFromLighting);
  const glm::dvec3 start = sight.org + before * sight.dir;
  const accel::ObjectRay ray{glm::vec3(spaces.objectFromLighting * glm::dvec4(start, 1)),
                             glm::vec3(linear * sight.dir), 0, std::numeric_limits<float>::infinity()};
  const auto hit = accel::meetSolid(placed, primitive, ray);
  if (!hit) return {sight.org + axis * sight.dir, computed.normal};
  const glm::dvec3 normal = glm::normalize(glm::transpose(linear) * glm::dvec3(hit->normal));
  return {start + double{hit->t} * sight.dir, glm::dot(normal, sight.dir) > 0 ? -normal : normal};
}

glm::dvec3 laneOf(const Row (&rows)[3], int i) { return {rows[0][i], rows[1][i], rows[2][i]}; }

}  // namespace

void solidPoints(const Metric& metric, const FrameData& frame, const ColoredHits& hits, Row (&point)[3],
                 Row (&normal)[3]) {
  const Group& group = hits.group;
  const accel::PlacedImpostors& placed = frame.world->impostorsOf(hits.instance);
  const Spaces spaces(placed);
  const glm::dmat3 normalFromLighting = glm::transpose(glm::dmat3(glm::dmat4(placed.lightingFromEye)));
  const auto put = [&](int i, const Point& p) {
    for (int c = 0; c < 3; ++c)
      point[c][i] = static_cast<float>(p.point[c]), normal[c][i] = static_cast<float>(p.normal[c]);
  };
  // Programs draw it on a billboard. Rays through a lens meet whole spheres.
  const bool flat = scene::isInWindow(placed.mesh->shape) || (placed.look.hemispheres && !frame.lens);
  const glm::dmat3 lightingFromEye(glm::dmat4(placed.lightingFromEye));
  const double thickest = 4.0 * metric.diagonal *
                          std::max({glm::length(lightingFromEye[0]), glm::length(lightingFromEye[1]),
                                    glm::length(lightingFromEye[2])});
  const int leader = std::countr_zero(group.lanes);
  for (int i = 0; i < kLanes; ++i) {
    const int lane = group.lanes >> i & 1 ? i : leader;
    Point p{laneOf(group.point, lane), laneOf(group.normal, lane)};
    if (flat) {
      const LineOfSight sight = sightThrough(hits.surface.impostors, hits.x[lane], hits.y[lane]);
      p = seenAlong(sight, placed, spaces, group.primitive[lane], thickest, p);
    }
    put(i, {glm::dvec3(spaces.eyeFromLighting * glm::dvec4(p.point, 1)),
            glm::normalize(normalFromLighting * p.normal)});
  }
}

}  // namespace gluray::render
