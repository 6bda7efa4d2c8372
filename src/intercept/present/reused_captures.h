// Images of a framebuffer whose memory is reused once no snapshot refers to them. Allocated on the GL
// thread, released on any thread.
#pragma once
#include "scene/framebuffer_capture.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gluray::present {

class ReusedCaptures {
 public:
  /// An image whose pixels have no meaning yet. Throws std::bad_alloc.
  std::shared_ptr<scene::FramebufferCapture> takeCapture() {
    std::unique_ptr<scene::FramebufferCapture> capture = unused_->takeCapture();
    if (!capture) capture = std::make_unique<scene::FramebufferCapture>();
    return {capture.release(), [to = unused_](scene::FramebufferCapture* left) { to->keep(left); }};
  }

 private:
  static constexpr size_t kKept = 2;  // the last frame's, and the one before it while it is refined
  struct Unused {
    std::mutex mutex;
    std::vector<std::unique_ptr<scene::FramebufferCapture>> captures;
    Unused() { captures.reserve(kKept); }
    std::unique_ptr<scene::FramebufferCapture> takeCapture() {
      const std::lock_guard lock(mutex);
      if (captures.empty()) return nullptr;
      std::unique_ptr<scene::FramebufferCapture> capture = std::move(captures.back());
      captures.pop_back();
      return capture;
    }
    void keep(scene::FramebufferCapture* left) noexcept {
      std::unique_ptr<scene::FramebufferCapture> capture(left);
      const std::lock_guard lock(mutex);
      if (captures.size() < kKept) captures.push_back(std::move(capture));
    }
  };
  std::shared_ptr<Unused> unused_ = std::make_shared<Unused>();
};

}  // namespace gluray::present
