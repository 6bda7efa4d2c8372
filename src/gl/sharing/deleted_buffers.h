// The names of the buffers that a share group has deleted. GL threads.
#pragma once

#include <GL/gl.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <unordered_map>

namespace gluray::gl {

/// The names of a share group's deleted buffers. The unit of time is one deletion.
class DeletedBuffers {
 public:
  void add(GLuint name) {
    const std::lock_guard lock(mutex_);
    when_[name] = ++now_;
  }
  uint64_t now() const { return now_; }  // 0: none was deleted
  /// When `name` was last deleted; 0: never.
  uint64_t when(GLuint name) const {
    const std::lock_guard lock(mutex_);
    const auto it = when_.find(name);
    return it == when_.end() ? 0 : it->second;
  }

 private:
  mutable std::mutex mutex_;
  std::unordered_map<GLuint, uint64_t> when_;
  std::atomic<uint64_t> now_ = 0;
};

}  // namespace gluray::gl
