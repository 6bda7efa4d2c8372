// Pictures of a framebuffer whose memory is reused once no snapshot refers to them. Allocated on the GL
// thread, released on any thread.
#pragma once
#include "scene/framebuffer_picture.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gluray::present {

class ReusedPictures {
 public:
  /// A picture whose pixels have no meaning yet. Throws std::bad_alloc.
  std::shared_ptr<scene::FramebufferPicture> takePicture() {
    std::unique_ptr<scene::FramebufferPicture> picture = unused_->takePicture();
    if (!picture) picture = std::make_unique<scene::FramebufferPicture>();
    return {picture.release(), [to = unused_](scene::FramebufferPicture* left) { to->keep(left); }};
  }

 private:
  static constexpr size_t kKept = 2;  // the last frame's, and the one before it while it is refined
  struct Unused {
    std::mutex mutex;
    std::vector<std::unique_ptr<scene::FramebufferPicture>> pictures;
    Unused() { pictures.reserve(kKept); }
    std::unique_ptr<scene::FramebufferPicture> takePicture() {
      const std::lock_guard lock(mutex);
      if (pictures.empty()) return nullptr;
      std::unique_ptr<scene::FramebufferPicture> picture = std::move(pictures.back());
      pictures.pop_back();
      return picture;
    }
    void keep(scene::FramebufferPicture* left) noexcept {
      std::unique_ptr<scene::FramebufferPicture> picture(left);
      const std::lock_guard lock(mutex);
      if (pictures.size() < kKept) pictures.push_back(std::move(picture));
    }
  };
  std::shared_ptr<Unused> unused_ = std::make_shared<Unused>();
};

}  // namespace gluray::present
