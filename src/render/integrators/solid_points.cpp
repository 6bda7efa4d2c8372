#include "render/integrators/solid_points.h"

#include "accel/impostors/solid.h"

#include <bit>
#include <limits>

namespace gluray::render {
namespace {

struct Point {
  glm::dvec3 point, normal;  // eye space
};

/// The spaces of one instance's impostors.
struct Spaces {
  glm::dmat4 eyeFromLighting, eyeFromObject, objectFromEye;
  explicit Spaces(const accel::PlacedImpostors& placed)
      : eyeFromLighting(glm::inverse(glm::dmat4(placed.lightingFromEye))),
        eyeFromObject(eyeFromLighting * glm::dmat4(placed.lightingFromObject)),
        objectFromEye(glm::inverse(eyeFromObject)) {}
};

/// The point of an impostor that is seen along the line of sight through a point that its program computed.
Point seenThrough(const Metric& metric, const accel::PlacedImpostors& placed, const Spaces& spaces,
                  uint32_t primitive, const Point& computed) {
  const glm::dvec3 away = glm::normalize(glm::dvec3(metric.away) - metric.away.w * computed.point);
  const glm::dmat3 linear(spaces.objectFromEye);
  // The ray starts in front of the point, farther than any impostor is thick.
  const double before = 4 * metric.diagonal;
  const accel::ObjectRay ray{glm::vec3(spaces.objectFromEye * glm::dvec4(computed.point - before * away, 1)),
                             glm::vec3(linear * away), 0, std::numeric_limits<float>::infinity()};
  const auto hit = accel::meetSolid(placed, primitive, ray);
  if (!hit) return computed;
  const glm::dvec3 normal = glm::normalize(glm::transpose(linear) * glm::dvec3(hit->normal));
  const glm::dvec3 object = glm::dvec3(ray.org) + double{hit->t} * glm::dvec3(ray.dir);
  return {glm::dvec3(spaces.eyeFromObject * glm::dvec4(object, 1)),
          glm::dot(normal, away) > 0 ? -normal : normal};
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
  const int leader = std::countr_zero(group.lanes);
  for (int i = 0; i < kLanes; ++i) {
    const int lane = group.lanes >> i & 1 ? i : leader;
    Point p{glm::dvec3(spaces.eyeFromLighting * glm::dvec4(laneOf(group.point, lane), 1)),
            glm::normalize(normalFromLighting * laneOf(group.normal, lane))};
    if (scene::isInWindow(placed.mesh->shape))
      p = seenThrough(metric, placed, spaces, group.primitive[lane], p);
    put(i, p);
  }
}

}  // namespace gluray::render
