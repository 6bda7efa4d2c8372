// Double hits of rays on edges between triangles, for layers (layers.inl.h).
#pragma once
#include "accel/rays/ray_packet.h"
#include "render/frame_data/frame_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gluray::render {

/// Finds double hits of one ray on an edge that two triangles share; only one counts. Impostors at the same
/// distance are two hits.
class EdgeHits {
 public:
  explicit EdgeHits(const FrameData& frame) : frame_(frame) {}
  /// The lanes whose hit the other triangle has reported already.
  uint32_t again(uint32_t lanes, const accel::RayPacket& packet) {
    constexpr float kAtEdge = 1e-5f, kSamePlace = 0x1p-20f;
    uint32_t found = 0;
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      const float u = packet.u[i], v = packet.v[i], distance = packet.tFar[i];
      if (std::min({u, v, 1 - u - v}) > kAtEdge) continue;
      if (frame_.surfaces[packet.instance[i]].mesh->shape != scene::Shape::triangles) continue;
      const auto isOther = [&](const Hit& hit) {
        return hit.instance == packet.instance[i] && hit.primitive != packet.primitive[i] &&
               std::abs(hit.distance - distance) <= kSamePlace * distance;
      };
      std::vector<Hit>& hits = hits_[i];
      const auto other = std::find_if(hits.begin(), hits.end(), isOther);
      if (other == hits.end()) {
        hits.push_back({packet.instance[i], packet.primitive[i], distance});
        continue;
      }
      hits.erase(other);
      found |= 1u << i;
    }
    return found;
  }

 private:
  struct Hit {
    uint32_t instance, primitive;
    float distance;
  };
  const FrameData& frame_;
  std::vector<Hit> hits_[kLanes];
};

}  // namespace gluray::render
