// The pixels that draws with the current state may change. GL thread, context current.
#pragma once
#include "gl/culled/clusters/box_visibility.h"
#include "gl/shadow/shadow_state.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::gl {

struct DrawnRegion {
  scene::Region drawn, inViewport;  // with, and without scissor test
  int samples = 1;                  // of a pixel
  bool reversed = false;            // larger depths are nearer
};
DrawnRegion drawnRegionOf(ShadowState& shadow);

/// Maps clip space to pixels relative to the lower corner of `region`, and to window depth; where the depth
/// function takes larger depths for nearer ones, to 1 - window depth.
WindowMapping mappingTo(const scene::Region& region, ShadowState& shadow);
/// Replaces window depths by 1 - depth, for such depth functions. Rounds to single precision, which the
/// margin of BoxVisibility covers.
void turnDepths(std::vector<float>& depths);

}  // namespace gluray::gl
