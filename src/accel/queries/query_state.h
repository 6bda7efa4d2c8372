// State that a World query passes to Embree's callbacks. Private to accel/; lives as long as one query, on
// its thread.
#pragma once
#include "accel/impostors/pixel_impostor.h"
#include "accel/rays/draw_order.h"
#include "accel/rays/hit_filter.h"
#include "accel/rays/next_hits.h"

#include <algorithm>

namespace gluray::accel {

/// Chooses among hits at equal distance the one that OpenGL's depth test would keep.
class TieBreaker {
 public:
  explicit TieBreaker(const DrawOrder& order) : order_(order) {}

  /// Whether the hit, no farther than the lane's best so far, replaces it. If so, `distance` becomes the
  /// ray's new end: slightly beyond this hit, so that hits at equal distance are still reported.
  bool replaces(int lane, uint32_t instance, uint32_t primitive, float& distance) {
    // Distances to triangles with the same corners in another order differ by a few roundings: less than one
    // step of 24-bit depth.
    constexpr float kFarther = 1 + 0x1p-21f;
    Best& best = best_[lane];
    const uint64_t rank = order_.rankOf(instance, primitive);
    const bool tie = best.found && best.distance <= distance * kFarther;
    if (tie && (rank > best.rank) != order_.laterWins) return false;
    best.distance = tie ? std::min(best.distance, distance) : distance;
    best.rank = rank;
    best.found = true;
    distance = best.distance * kFarther;
    return true;
  }

  /// Sets tFar back from the extended ray ends to the distances of the hits.
  void restoreDistances(RayPacket& packet) const {
    for (int i = 0; i < kLanes; ++i)
      if (best_[i].found) packet.tFar[i] = best_[i].distance;
  }

 private:
  struct Best {
    uint64_t rank;
    float distance;
    bool found = false;
  };
  const DrawOrder& order_;
  Best best_[kLanes];
};

struct QueryState {
  const HitFilter* filter;
  TieBreaker* ties;
  uint32_t aloneIndex;
  const PlacedImpostors* impostors = nullptr;  // per instance
  ImpostorQuery rays;
  WindowRectangle around;
  // Cache: `rays` in the lighting space of instance `raysOf`, the last one tested.
  mutable uint32_t raysOf = kNoHit;
  mutable ImpostorRays centers, samples;
  NextHits* next = nullptr;  // set: collect several hits per ray

  /// Whether a hit closer than the lane's best is accepted; `distance` as in TieBreaker::replaces.
  bool counts(int lane, uint32_t instance, uint32_t primitive, float u, float v, float& distance) const {
    if (next) return next->add(lane, {distance, u, v, instance, primitive}, distance);
    if (filter && !filter->accepts(instance, primitive, u, v, lane)) return false;
    return !ties || ties->replaces(lane, instance, primitive, distance);
  }
};

}  // namespace gluray::accel
