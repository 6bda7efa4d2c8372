#include "gl/views/view_frames.h"

#include "gl/batch/clears.h"

#include <algorithm>

namespace gluray::gl {

void ViewFrames::cleared(GLuint framebuffer, const scene::Region& box) noexcept {
  for (View& view : views_)
    if (view.framebuffer == framebuffer && contains(box, view.region)) view.isClear = true;
}

uint64_t ViewFrames::traced(GLuint framebuffer, const scene::Region& region) {
  constexpr size_t kMax = 64;  // of framebuffers and regions that come and go
  const auto known = std::ranges::find_if(
      views_, [&](const View& v) { return v.framebuffer == framebuffer && v.region == region; });
  if (known != views_.end()) {
    std::rotate(known, known + 1, views_.end());
    View& view = views_.back();
    if (view.isClear) ++view.frame, view.isClear = false;
    return view.frame;
  }
  if (views_.size() >= kMax) views_.erase(views_.begin());
  views_.push_back({framebuffer, region, 1, false});
  return 1;
}

}  // namespace gluray::gl
