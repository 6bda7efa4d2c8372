// The last textures and renderbuffers that a share group has deleted. GL threads.
#pragma once

#include <GL/gl.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace gluray::gl {

class DeletedImages {
 public:
  /// `type`: GL_TEXTURE or GL_RENDERBUFFER.
  void add(GLenum type, GLuint name) {
    const std::lock_guard lock(mutex_);
    last_[count_ % kKept] = {type, name};
    ++count_;
  }
  /// Number of deletions.
  uint64_t count() const { return count_; }
  /// Calls visit(type, name) for each deletion after the first `seen` ones, and sets `seen` to the total.
  /// Returns false if there were more than kKept, so that the older ones are unknown.
  template <class Visit>
  bool since(uint64_t& seen, Visit&& visit) const {
    if (seen == count_) return true;
    const std::lock_guard lock(mutex_);
    const bool known = count_ - seen <= kKept;
    for (uint64_t i = known ? seen : uint64_t{count_}; i < count_; ++i)
      visit(last_[i % kKept].type, last_[i % kKept].name);
    seen = count_;
    return known;
  }

 private:
  static constexpr size_t kKept = 1024;
  struct Image {
    GLenum type = GL_NONE;
    GLuint name = 0;
  };
  mutable std::mutex mutex_;
  std::array<Image, kKept> last_{};
  std::atomic<uint64_t> count_ = 0;
};

}  // namespace gluray::gl
