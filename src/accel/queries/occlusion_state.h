// What a query for occlusion carries into Embree's callbacks. Private to accel/; lives as long as one query.
#pragma once
#include "accel/impostors/placed_impostors.h"
#include "accel/rays/occlusion.h"

namespace gluray::accel {

struct OcclusionState {
  const OccluderFilter* filter;      // null: everything blocks
  uint32_t aloneIndex;               // the instance of hits that name none
  const PlacedImpostors* impostors;  // by instance; null where there are none

  /// `inside`: the instance that Embree names, which is none for a lone mesh.
  uint32_t instanceOf(uint32_t inside) const { return inside == kNoHit ? aloneIndex : inside; }
  bool blocks(const Occluder& occluder) const { return !filter || filter->blocks(occluder); }
};

}  // namespace gluray::accel
