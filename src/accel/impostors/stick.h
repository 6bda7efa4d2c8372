// Sticks (scene/mesh.h): cylinders between two points, whose ends are open, flat or round, in the space of
// Instance::lightingFromObject. accel/ intersects them, render/ shades them. Any thread.
#pragma once
#include "accel/impostors/placed_impostors.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace gluray::accel {

struct Stick {
  enum class End : uint8_t { open, flat, round };
  glm::vec3 end[2];
  End ends[2];
  bool halves;     // the colour changes in the middle
  glm::vec3 axis;  // unit, from end 0 to end 1
  float halfLength, radius;
  /// False if it does not exist: sticks without length or width.
  static bool make(const PlacedImpostors&, uint32_t primitive, Stick&);
  glm::vec3 middle() const { return 0.5f * (end[0] + end[1]); }
};

/// Returns which of `lanes` (bit i: lane i) hit the stick, and sets their t: the point where the ray enters
/// the mantle or a closed end. Points in front of the near plane or beyond the far plane do not count, so
/// that the stick has a hole there.
uint32_t meet(const Stick&, const ImpostorRays&, uint32_t lanes, float (&t)[kLanes]);

/// The visible point of a stick on a line of sight.
struct StickPoint {
  glm::dvec3 point;
  glm::vec3 normal;  // unit, outwards
  double share;      // position along the axis where the line enters the infinite cylinder, clamped to [0, 1]
  double enterZ;     // z of that point
};
/// `dir`: unit length, away from the viewer. For a line that misses the stick, returns a nearby point.
StickPoint see(const Stick&, const glm::dvec3& org, const glm::dvec3& dir);

struct StickHit {
  double t;
  glm::dvec3 normal;  // outwards, not of unit length
};
/// The nearest hit with t in [tNear, tFar] for secondary rays, for which open ends count as flat ends.
std::optional<StickHit> meetSolid(const Stick&, const glm::dvec3& org, const glm::dvec3& dir, double tNear,
                                  double tFar);

}  // namespace gluray::accel
