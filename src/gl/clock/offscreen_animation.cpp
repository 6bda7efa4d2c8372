#include "gl/clock/offscreen_animation.h"

#include <algorithm>
#include <cstdlib>

namespace gluray::gl {

bool OffscreenAnimation::isReduced(glm::ivec2 size) const {
  return std::ranges::any_of(views_, [&](const View& other) {
    const glm::i64vec2 large = other.size, small = size;
    // Equal shapes, up to the rounding of both sides.
    return large.x > small.x && std::abs(large.x * small.y - large.y * small.x) <= large.x + large.y;
  });
}

bool OffscreenAnimation::isAnimated(glm::ivec2 size, uint64_t frame, double now) {
  constexpr size_t kMax = 16;  // sizes that are remembered
  const auto known = std::ranges::find(views_, size, &View::size);
  if (known == views_.end()) {
    if (views_.size() >= kMax) views_.erase(views_.begin());
    views_.push_back({size, frame, isReduced(size), now});
    return views_.back().animated;
  }
  std::rotate(known, known + 1, views_.end());
  View& view = views_.back();
  if (view.frame == frame) return view.animated;
  view.frame = frame;
  return view.animated = now - view.drawn <= kPause || isReduced(size);
}

}  // namespace gluray::gl
