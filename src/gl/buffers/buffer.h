// Buffer objects. Our copy is the copy: meshes read it in place, and the real OpenGL gets it when it needs
// it. GL threads: contexts of several threads may draw from a buffer at once, and each sends what the others
// hold back; changes of contents follow OpenGL's rule that programs synchronise them with their use.
#pragma once
#include "gl/real.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

namespace gluray::gl {

class Context;

/// Bytes of a buffer, followed by 16 readable ones. Never changed while a mesh refers to it.
struct BufferStorage {
  explicit BufferStorage(size_t sizeBytes);  // throws std::bad_alloc
  ~BufferStorage();
  BufferStorage(const BufferStorage&) = delete;
  BufferStorage& operator=(const BufferStorage&) = delete;
  std::byte* data;
  size_t size;
};

/// A flag that is counted over all buffers of the process while it is set.
class CountedFlag {
 public:
  CountedFlag() = default;
  ~CountedFlag() { *this = false; }
  CountedFlag(const CountedFlag&) = delete;
  CountedFlag& operator=(bool on) {
    if (on_.exchange(on) != on) set_ += on ? 1 : -1;
    return *this;
  }
  operator bool() const { return on_; }
  static bool anySet() { return set_ > 0; }

 private:
  std::atomic<bool> on_ = false;
  static inline std::atomic<int> set_ = 0;
};

class Buffer {
 public:
  explicit Buffer(GLuint name);

  /// glBufferData: new contents (null: undefined), ours alone until the real OpenGL needs them.
  void setData(size_t size, const void* data, GLenum usage);
  /// glBufferSubData within the size.
  void setSubData(size_t offset, size_t size, const void* data);
  /// Whether commands that read or write this range are errors because of a mapping of ours.
  bool mappedIn(size_t offset, size_t size) const {
    return mapped() && size > 0 && offset < mapOffset_ + mapLength_ && mapOffset_ < offset + size;
  }
  /// The bytes, fetched from the real OpenGL where it has changed them. Null for an empty buffer.
  std::shared_ptr<const BufferStorage> read(const RealGl& real);
  /// Gives the real OpenGL our contents if it does not have them. While the buffer is mapped nobody may draw
  /// from it: then only memory, so that who does so all the same harms nobody.
  void sendTo(const RealGl& real);
  /// The real OpenGL is about to change, or has changed, the contents itself; a mapped buffer it cannot.
  void changedBelow();

  /// glMapBuffer(Range) on our copy: a pointer that stays valid until unmap().
  void* map(const RealGl& real, size_t offset, size_t length, GLbitfield access);
  void unmap();

  GLuint name() const { return name_; }
  uint64_t serial() const { return serial_; }  // unlike names and addresses never used again
  size_t size() const { return size_; }        // bytes
  bool immutable = false;  // glBufferStorage: the real OpenGL's storage cannot be made anew
  GLenum usage() const { return usage_; }
  bool heldBack() const { return heldBack_; }
  /// Whether any buffer of the process is.
  static bool anyHeldBack() { return CountedFlag::anySet(); }
  /// Bytes that sendTo() has given the real OpenGL since the process began. Any thread.
  static uint64_t bytesSent();
  uint64_t version() const { return version_; }
  bool mapped() const { return mapped_ != nullptr; }
  void* mappedPointer() const { return mapped_; }
  size_t mapOffset() const { return mapOffset_; }
  size_t mapLength() const { return mapLength_; }
  GLbitfield mapAccess() const { return mapAccess_; }

  /// The real OpenGL or the program writes into it in ways that we do not see (transform feedback, shader
  /// storage, persistent mapping): never traced, and what we read of it we read anew.
  bool foreign = false;
  bool persistent = false;  // by a persistent mapping; then foreign, too
  /// The real OpenGL reads it without our being asked (uniform blocks, buffer textures, pixels): it gets the
  /// contents at once.
  bool readBelow = false;
  /// The program knows the size although our copy is gone.
  void setSizeBelow(size_t size, GLenum usage);
  /// The program has mapped the real OpenGL's memory, through a target whose contents are not held back.
  bool mappedBelow = false;

 private:
  /// Storage that may be written: copied first where a mesh still refers to it.
  BufferStorage& writable();
  void fetch(const RealGl& real);

  std::mutex mutex_;  // of what follows, where a context that only draws may come by
  GLuint name_;
  uint64_t serial_;
  std::shared_ptr<BufferStorage> storage_;  // null: the real OpenGL has the only copy
  size_t size_ = 0;
  GLenum usage_ = GL_STATIC_DRAW;
  CountedFlag heldBack_;               // ours is newer than the real one
  bool memoryBelow_ = false;           // the real one has memory of this size
  std::atomic<uint64_t> version_ = 1;  // counts changes of content
  void* mapped_ = nullptr;
  std::shared_ptr<BufferStorage> mappedStorage_;  // what the pointer points into
  size_t mapOffset_ = 0, mapLength_ = 0;
  GLbitfield mapAccess_ = 0;
};

}  // namespace gluray::gl
