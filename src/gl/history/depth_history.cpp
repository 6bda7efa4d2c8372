#include "gl/history/depth_history.h"

#include "gl/batch/clears.h"
#include "gl/shadow/shadow_state.h"

#include <algorithm>

namespace gluray::gl {

DepthPlace depthPlaceOf(ShadowState& shadow) {
  shadow.refresh(kTarget | kViewport);
  const ViewportState& viewport = shadow.viewport();
  return {shadow.target().framebuffer, viewport.box, viewport.region()};
}

bool DepthClear::removes(const DepthPlace& place) const {
  return place.framebuffer == framebuffer && contains(box, place.region);
}

void DepthHistory::clear(const DepthClear& clear) {
  nextTurn();
  // All surfaces that are still remembered were drawn after these old clears.
  std::erase_if(cleared_, [&](const auto& one) { return one.second.back().turn + kMaxTurns < turn_; });
  std::vector<ClearedBox>& boxes = cleared_[clear.framebuffer];
  std::erase_if(boxes, [&](const ClearedBox& one) { return contains(clear.box, one.box); });
  if (boxes.size() >= kMaxBoxes) boxes.erase(boxes.begin());
  boxes.push_back({clear.box, turn_});
}

bool DepthHistory::reaches(const DepthStamp& drawn, const DepthPlace& now) const {
  const bool same = drawn.place.framebuffer == now.framebuffer;
  if (same && !scene::haveCommonPixels(drawn.place.region, now.region)) return false;
  const auto cleared = cleared_.find(now.framebuffer);
  if (cleared == cleared_.end()) return true;
  const std::vector<ClearedBox>& boxes = cleared->second;
  if (!same) return drawn.turn >= boxes.back().turn;
  return std::none_of(boxes.begin(), boxes.end(), [&](const ClearedBox& one) {
    return drawn.turn < one.turn && contains(one.box, now.region);
  });
}

}  // namespace gluray::gl
