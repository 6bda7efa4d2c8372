// Tests whether Embree can trace a ray. Any thread.
#pragma once
#include <algorithm>
#include <cmath>
#include <iterator>

namespace gluray::accel {

/// Whether lane i has a ray that Embree can trace. Embree aborts the process if an active lane has any other
/// ray. `Rays`: RayPacket or OcclusionRays.
template <class Rays>
bool isTraceable(const Rays& r, int i) {
  constexpr float kLargest = 1e18f;
  const float values[] = {r.orgX[i], r.orgY[i], r.orgZ[i], r.dirX[i], r.dirY[i], r.dirZ[i]};
  return std::all_of(std::begin(values), std::end(values),
                     [](float v) { return std::abs(v) <= kLargest; }) &&  // false for NaN
         r.tNear[i] >= 0 &&
         r.tNear[i] <= r.tFar[i];
}

}  // namespace gluray::accel
