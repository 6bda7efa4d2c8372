// The nearest hits of each ray of a packet, from one query (World::intersectNext). One thread per packet.
#pragma once
#include "accel/rays/ray_packet.h"

#include <algorithm>
#include <vector>

namespace gluray::accel {

class NextHits {
 public:
  static constexpr int kMax = 8;  // hits per ray and query
  struct Hit {
    float distance = 0, u = 0, v = 0;  // as in RayPacket
    uint32_t instance = 0, primitive = 0;
  };

  int count(int lane) const { return counts_[lane]; }
  /// Sorted by distance, nearest first.
  const Hit& at(int lane, int i) const { return hits_[lane][i]; }
  /// Whether the ray may have more hits beyond these.
  bool full(int lane) const { return counts_[lane] == kMax; }

  /// Makes later queries skip the lane's hits. Returns the tNear for the next query: slightly less than the
  /// last hit's distance, because more hits may lie there, up to rounding. Requires full().
  float passOn(int lane) {
    constexpr float kBefore = 1 - 0x1p-20f;
    const float from = hits_[lane][kMax - 1].distance * kBefore;
    std::vector<Hit>& passed = passed_[lane];
    std::erase_if(passed, [&](const Hit& hit) { return hit.distance < from; });
    for (const Hit& hit : hits_[lane])
      if (hit.distance >= from) passed.push_back(hit);
    counts_[lane] = 0;
    return from;
  }

  /// Inserts a hit that a query found. True: the list is full; sets `distance` to the ray's new end.
  bool add(int lane, const Hit& hit, float& distance) noexcept {
    const auto isThis = [&](const Hit& h) {
      return h.instance == hit.instance && h.primitive == hit.primitive;
    };
    if (std::any_of(passed_[lane].begin(), passed_[lane].end(), isThis)) return false;
    Hit* const hits = hits_[lane];
    int& count = counts_[lane];
    if (count == kMax && hit.distance >= hits[kMax - 1].distance) return false;
    int at = std::min(count, kMax - 1);
    for (; at > 0 && hits[at - 1].distance > hit.distance; --at) hits[at] = hits[at - 1];
    hits[at] = hit;
    count = std::min(count + 1, kMax);
    if (count < kMax) return false;
    distance = hits[kMax - 1].distance;
    return true;
  }

 private:
  int counts_[kLanes] = {};
  Hit hits_[kLanes][kMax];
  std::vector<Hit> passed_[kLanes];  // processed hits near the start of the next query
};

}  // namespace gluray::accel
