// Balls and capsules (scene/mesh.h): points as spheres and lines as tubes, in the space of
// Instance::lightingFromObject. accel/ intersects them, render/ shades them. Any thread.
#pragma once
#include "accel/impostors/placed_impostors.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::accel {

/// The convex hull of two balls: the balls, and the cone that touches both along circles. A ball is a capsule
/// whose ends are equal.
struct Capsule {
  glm::vec3 end[2];         // centres
  float radius[2];          // of the balls
  float share[2] = {0, 1};  // places of the ends on the primitive's line
  glm::vec3 axis{0, 0, 1};  // unit, from end 0 to end 1
  float halfLength = 0;
  float sine = 0;  // of the angle between the cone's sides and the axis; positive: narrows towards end 1
  /// Returns false if it does not exist: lines without length, and impostors cut away by clip planes or, for
  /// sizes in pixels, by the near plane.
  static bool make(const PlacedImpostors&, uint32_t primitive, Capsule&);
  /// Whether one ball contains the other; then the capsule is the larger ball, at both ends.
  bool isBall() const { return halfLength == 0; }
  bool holds(const glm::vec3& point) const;
};

/// Lanes that hit a capsule, as bits, and those of them that enter it in front of the near plane.
struct CapsuleHits {
  uint32_t lanes = 0, early = 0;
};

/// Returns which of `lanes` (bit i: lane i) hit the capsule, and sets their t >= 0: the entry point, or 0 if
/// that lies in front of the near plane. A capsule that contains the viewer is invisible.
uint32_t meet(const PlacedImpostors&, const Capsule&, const ImpostorRays&, uint32_t lanes,
              float (&t)[kLanes]);

/// The point where a line of sight enters a capsule.
struct CapsulePoint {
  glm::dvec3 point;
  glm::vec3 normal;  // unit, outwards
  float cosine;      // of the angle between the normal and the direction to the viewer
  float share;       // place on the primitive's line: 0 at its first vertex, 1 at its second
};
/// `dir`: unit length, away from the viewer. For a line that misses the capsule, returns the nearest point.
CapsulePoint see(const Capsule&, const glm::dvec3& org, const glm::dvec3& dir);

}  // namespace gluray::accel
