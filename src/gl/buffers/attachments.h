// When buffers were put into vertex array objects. A buffer that is deleted lives on in those that are not
// bound (OpenGL 4.6, 5.1.2 and 5.1.3), and the name that the real OpenGL tells of it may mean another one by
// then. GL threads.
#pragma once

#include <GL/gl.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <unordered_map>

namespace gluray::gl {

class Buffer;
struct ArrayState;

/// Names of buffers, or of renderbuffers, that were deleted, of a share group. Time is counted in deletions.
class DeletedBuffers {
 public:
  void add(GLuint name) {
    const std::lock_guard lock(mutex_);
    when_[name] = ++now_;
  }
  uint64_t now() const { return now_; }  // 0: none was deleted
  /// 0: never.
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

/// Of one context: vertex array objects are not shared.
class Attachments {
 public:
  /// Places in a vertex array object: those of generic attributes by binding, up to kElements.
  enum Place : GLuint {
    kElements = 32,
    kVertex,
    kNormal,
    kColor,
    kSecondaryColor,
    kFogCoord,
    kTexCoord,  // of unit 0, those of seven more units after it
    kPlaces = kTexCoord + 8
  };

  explicit Attachments(const DeletedBuffers& deleted) : deleted_(deleted) {}

  void bind(GLuint array) { bound_ = array, any_ = any_ || array != 0; }
  /// Whether there are others than the one of the context itself.
  bool any() const { return any_; }
  /// A buffer is put there now.
  void set(GLuint place) { set(bound_, place); }
  void set(GLuint array, GLuint place);
  /// What the bound one holds may be older than it looks, or it is gone.
  void forget() { when_.erase(bound_); }
  void forget(GLuint array) { when_.erase(array); }
  /// The same of a target that is no part of vertex array objects: a buffer that another context deletes
  /// stays bound to it.
  void setTarget(GLenum target);
  /// Whether what is bound to `target`, GL_ELEMENT_ARRAY_BUFFER too, may be a deleted buffer that had the
  /// name before. What was bound in other ways than by glBindBuffer (glBindBufferBase ...) is taken for old.
  bool mayBeDeletedAt(GLenum target, GLuint name) const;
  /// Refuses arrays of the bound one that may lie in deleted buffers: Reason::deletedBuffer.
  void check(ArrayState& arrays) const;

 private:
  bool mayBeDeleted(GLuint place, GLuint name) const;

  const DeletedBuffers& deleted_;
  GLuint bound_ = 0;
  bool any_ = false;
  std::unordered_map<GLuint, std::array<uint64_t, kPlaces>> when_;  // 0: before the first deletion
  std::unordered_map<GLenum, uint64_t> targets_;                    // likewise
};

}  // namespace gluray::gl
