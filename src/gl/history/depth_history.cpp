#include "gl/history/depth_history.h"

#include "gl/batch/clears.h"
#include "gl/shadow/shadow_state.h"

#include <algorithm>

namespace gluray::gl {

DepthPlace depthPlaceOf(ShadowState& shadow) {
  shadow.refresh(kTarget | kViewport);
  return {shadow.target().framebuffer, shadow.viewport().box};
}

bool DepthClear::removes(const DepthPlace& place) const {
  if (place.framebuffer != framebuffer) return false;
  const glm::ivec4& v = place.viewport;
  // Pixels have no negative coordinates.
  return contains(box, {std::max(v.x, 0), std::max(v.y, 0), v.z + std::min(v.x, 0), v.w + std::min(v.y, 0)});
}

void DepthHistory::clear(const DepthClear& clear) {
  nextTurn();
  // All surfaces that are still remembered were drawn after these old clears.
  std::erase_if(cleared_, [&](const auto& one) { return one.second + kMaxTurns < turn_; });
  cleared_[clear.framebuffer] = turn_;
}

bool DepthHistory::reaches(const DepthStamp& drawn, uint32_t framebuffer) const {
  if (drawn.place.framebuffer == framebuffer) return true;
  const auto last = cleared_.find(framebuffer);
  return last == cleared_.end() || drawn.turn >= last->second;
}

}  // namespace gluray::gl
