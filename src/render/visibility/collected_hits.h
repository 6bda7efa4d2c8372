// All hits of a packet's rays, unordered. Used by the kernels; one per thread.
#pragma once
#include "accel/world.h"
#include "render/frame_data/frame_data.h"

#include <cstddef>
#include <new>
#include <vector>

namespace gluray::render {

class CollectedHits {
 public:
  void clear() {
    for (std::vector<Hit>& hits : of_) hits.clear();
  }
  /// Adds a hit; drops it if out of memory.
  void add(int lane, uint32_t instance, uint32_t primitive, float u, float v) noexcept {
    try {
      of_[lane].push_back({instance, primitive, u, v});
    } catch (const std::bad_alloc&) {}
  }
  /// Copies the n-th hit of each lane, except its distance, into the packet. Returns the lanes that have one.
  uint32_t copyHits(size_t n, accel::RayPacket& packet) const {
    uint32_t lanes = 0;
    for (int i = 0; i < accel::kLanes; ++i) {
      if (n >= of_[i].size()) continue;
      const Hit& hit = of_[i][n];
      packet.instance[i] = hit.instance, packet.primitive[i] = hit.primitive;
      packet.u[i] = hit.u, packet.v[i] = hit.v;
      lanes |= 1u << i;
    }
    return lanes;
  }

 private:
  struct Hit {
    uint32_t instance, primitive;
    float u, v;
  };
  std::vector<Hit> of_[accel::kLanes];
};

/// Collects hits that are neither culled nor clipped by instances' own planes. Rejects every hit, so that
/// rays continue.
class CollectingFilter : public accel::HitFilter {
 public:
  CollectingFilter(const FrameData& frame, CollectedHits& hits) : frame_(frame), hits_(hits) {}
  bool accepts(uint32_t instance, uint32_t primitive, float u, float v, int lane) const noexcept override {
    if (frame_.surfaces[instance].accepts(primitive, u, v)) hits_.add(lane, instance, primitive, u, v);
    return false;
  }

 private:
  const FrameData& frame_;
  CollectedHits& hits_;
};

}  // namespace gluray::render
