// State that an occlusion query passes to Embree's callbacks. Private to accel/; lives as long as one query.
#pragma once
#include "accel/impostors/placed_impostors.h"
#include "accel/rays/occlusion.h"

namespace gluray::accel {

struct OcclusionState {
  const OccluderFilter* filter;      // null: all surfaces block
  uint32_t aloneIndex;               // the instance of hits without an instance
  const PlacedImpostors* impostors;  // by instance; null without impostors

  /// `inside`: instance reported by Embree, kNoHit for a single mesh without TLAS.
  uint32_t instanceOf(uint32_t inside) const { return inside == kNoHit ? aloneIndex : inside; }
  bool blocks(const Occluder& occluder) const { return !filter || filter->blocks(occluder); }
};

}  // namespace gluray::accel
