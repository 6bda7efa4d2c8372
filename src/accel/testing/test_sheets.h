// Two bumpy sheets of triangles, and packets of rays through them, for tests of triangle blocks and bundles.
#pragma once
#include "accel/testing/test_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gluray::test {

using accel::kLanes;
using accel::kNoHit;
using accel::RayPacket;

inline constexpr uint32_t kSide = 64;  // cells

/// Two layers of a bumpy sheet over [-1, 1]^2, row by row.
inline MeshData sheets() {
  MeshData data;
  for (int layer = 0; layer < 2; ++layer) {
    const auto first = static_cast<uint32_t>(data.positions.size());
    for (uint32_t y = 0; y <= kSide; ++y)
      for (uint32_t x = 0; x <= kSide; ++x) {
        const float u = 2 * static_cast<float>(x) / kSide - 1, v = 2 * static_cast<float>(y) / kSide - 1;
        data.positions.push_back(
            {u, v, 0.2f * std::sin(9 * u) * std::cos(7 * v) - static_cast<float>(layer)});
      }
    for (uint32_t y = 0; y < kSide; ++y)
      for (uint32_t x = 0; x < kSide; ++x) {
        const uint32_t a = first + y * (kSide + 1) + x, b = a + 1, c = a + kSide + 1, d = c + 1;
        data.indices.insert(data.indices.end(), {a, b, d, a, d, c});
      }
  }
  return data;
}

/// One sheet cut into patches of eight triangles, each at a depth of its own: blocks that are too far apart
/// for bundles.
inline MeshData patches() {
  const MeshData whole = sheets();
  MeshData data;
  for (uint32_t t = 0; t < 2 * kSide * kSide; ++t) {
    const float away = 9 * std::fmod(static_cast<float>(t / 8) * 0.6180339f, 1.0f);
    for (uint32_t k = 0; k < 3; ++k)
      data.positions.push_back(whole.positions[whole.indices[3 * t + k]] - glm::vec3(0, 0, away));
  }
  return data;
}

/// The triangles of `data`, reordered so that consecutive ones are far apart.
inline MeshData shuffled(const MeshData& data) {
  MeshData other = data;
  const size_t count = data.indices.size() / 3;
  for (size_t t = 0; t < count; ++t)
    std::copy_n(data.indices.begin() + static_cast<ptrdiff_t>((t * 4099 % count) * 3), 3,
                other.indices.begin() + static_cast<ptrdiff_t>(t * 3));
  return other;
}

inline MeshData soupOf(const MeshData& data) {
  MeshData soup;
  for (const uint32_t i : data.indices) soup.positions.push_back(data.positions[i]);
  return soup;
}

/// Packet `number` of slightly oblique rays through the sheets.
inline RayPacket packetOf(uint32_t number) {
  RayPacket packet{};
  for (int i = 0; i < kLanes; ++i) {
    const uint32_t ray = number * kLanes + static_cast<uint32_t>(i);
    packet.orgX[i] = 2.1f * std::fmod(static_cast<float>(ray) * 0.6180339f, 1.0f) - 1.05f;
    packet.orgY[i] = 2.1f * std::fmod(static_cast<float>(ray) * 0.7548776f, 1.0f) - 1.05f;
    packet.orgZ[i] = 3;
    packet.dirX[i] = 0.05f, packet.dirY[i] = -0.03f, packet.dirZ[i] = -1;
    packet.tFar[i] = std::numeric_limits<float>::infinity();
    packet.mask[i] = ~0u;
    packet.geometry[i] = packet.instance[i] = kNoHit;
    packet.id[i] = static_cast<uint32_t>(i);
  }
  return packet;
}

}  // namespace gluray::test
