// Rays for the tests of accel/.
#pragma once
#include "accel/world.h"

#include <algorithm>
#include <limits>

namespace gluray::test {

/// Sixteen rays down -z from z = 10, ray i from (x + i dx, y + i dy).
inline accel::RayPacket raysDown(float x, float y, float dx = 0, float dy = 0) {
  accel::RayPacket packet{};
  for (int i = 0; i < accel::kLanes; ++i) {
    packet.orgX[i] = x + dx * static_cast<float>(i), packet.orgY[i] = y + dy * static_cast<float>(i);
    packet.orgZ[i] = 10, packet.dirZ[i] = -1;
    packet.tFar[i] = std::numeric_limits<float>::infinity();
    packet.mask[i] = ~0u;
    packet.geometry[i] = packet.instance[i] = accel::kNoHit;
    packet.id[i] = static_cast<uint32_t>(i);
  }
  return packet;
}

/// The packet after tracing all of its rays in `world`.
inline accel::RayPacket shot(const accel::World& world, accel::RayPacket packet,
                             const accel::HitFilter* filter = nullptr) {
  alignas(64) int32_t valid[accel::kLanes];
  std::fill_n(valid, accel::kLanes, -1);
  world.intersect(valid, packet, filter);
  return packet;
}

}  // namespace gluray::test
