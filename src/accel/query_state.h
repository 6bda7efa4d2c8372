// What a query of World carries into Embree's callbacks. Private to accel/; lives as long as one query.
#pragma once
#include "accel/impostors/pixel_impostor.h"
#include "accel/next_hits.h"
#include "accel/world.h"

#include <algorithm>

namespace gluray::accel {

/// Of hits at one distance, the one that OpenGL's depth test would leave.
class TieBreaker {
 public:
  explicit TieBreaker(const DrawOrder& order) : order_(order) {}

  /// Whether the hit, no farther than the lane's best so far, takes its place; `distance` then becomes how
  /// far the ray is to look on: hits as far as this one must still be asked about.
  bool replaces(int lane, uint32_t instance, uint32_t primitive, float& distance) {
    // Triangles with the same corners in another order are hit up to a few roundings apart; less than 24-bit
    // depth tells apart.
    constexpr float kFarther = 1 + 0x1p-21f;
    Best& best = best_[lane];
    const uint64_t rank = uint64_t{order_.ranks[instance]} << 32 | primitive;
    const bool tie = best.found && best.distance <= distance * kFarther;
    if (tie && (rank > best.rank) != order_.laterWins) return false;
    best.distance = tie ? std::min(best.distance, distance) : distance;
    best.rank = rank;
    best.found = true;
    distance = best.distance * kFarther;
    return true;
  }

  /// The distances of the hits in place of how far the rays looked on.
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

/// What callbacks need.
struct QueryState {
  const HitFilter* filter;
  TieBreaker* ties;
  uint32_t aloneIndex;
  const PlacedImpostors* impostors = nullptr;  // by instance
  ImpostorQuery rays;
  WindowRectangle around;
  // Those in the lighting space of the instance that was asked about last.
  mutable uint32_t raysOf = kNoHit;
  mutable ImpostorRays centers, samples;
  NextHits* next = nullptr;  // several hits are wanted

  /// Whether a hit closer than the lane's best counts; `distance` as TieBreaker::replaces.
  bool counts(int lane, uint32_t instance, uint32_t primitive, float u, float v, float& distance) const {
    if (next) return next->add(lane, {distance, u, v, instance, primitive}, distance);
    if (filter && !filter->accepts(instance, primitive, u, v, lane)) return false;
    return !ties || ties->replaces(lane, instance, primitive, distance);
  }
};

}  // namespace gluray::accel
