// Conservative intersection of rays and solids in single precision: definite hits and misses are exact. Any
// thread.
#pragma once
#include "accel/impostors/placed_impostors.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace gluray::accel {

/// The convex hull of two balls in lighting space; of one ball where their centres are equal.
struct RoundHull {
  glm::vec3 end[2];
  float radius[2];
  bool whole = true;   // the solid equals the hull
  bool leaves = true;  // rays that start inside meet it where they leave it
};

/// The hull of an impostor's solid (solid.h); none if the solid is not such a hull or does not exist.
std::optional<RoundHull> hullOf(const PlacedImpostors&, uint32_t primitive);

/// Definite results of meetSolid(). Lanes in neither set are undecided, because rounding could decide.
struct SolidGuess {
  uint32_t misses = 0, hits = 0;  // bit i: lane i
};

/// `rays`: rows of `count` <= 16 values, in the order of Embree's RTCRayN: origin x y z, tNear, direction x y
/// z, time, tFar; object space.
SolidGuess guessSolid(const PlacedImpostors&, const RoundHull&, const float* rays, unsigned count,
                      uint32_t lanes);

}  // namespace gluray::accel
