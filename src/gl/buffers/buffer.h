// Buffer objects. GLuRay's copy of the contents is the primary one: meshes read it in place, and the real
// OpenGL gets it when it needs it. GL threads: contexts on several threads may draw from a buffer at once,
// and each sends updates that other contexts have held back. Host programs must synchronise changes of
// contents with their use, as OpenGL requires.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

namespace gluray::gl {

class Context;

/// The bytes of a buffer, followed by 16 readable ones. Never changed while a mesh refers to them.
struct BufferStorage {
  /// Alignment of `data` in bytes: at least GL_MIN_MAP_BUFFER_ALIGNMENT of all known OpenGL implementations.
  static constexpr size_t kAlignment = 64;
  explicit BufferStorage(size_t sizeBytes);  // throws std::bad_alloc
  ~BufferStorage();
  BufferStorage(const BufferStorage&) = delete;
  BufferStorage& operator=(const BufferStorage&) = delete;
  std::byte* data;
  size_t size;
};

using SharedCount = std::shared_ptr<std::atomic<int>>;

/// A flag that also counts in `set` how many flags of a share group are set.
class CountedFlag {
 public:
  explicit CountedFlag(SharedCount set) : set_(std::move(set)) {}
  ~CountedFlag() { *this = false; }
  CountedFlag(const CountedFlag&) = delete;
  CountedFlag& operator=(bool on) {
    if (on_.exchange(on) != on) *set_ += on ? 1 : -1;
    return *this;
  }
  operator bool() const { return on_; }

 private:
  std::atomic<bool> on_ = false;
  SharedCount set_;
};

class Buffer {
 public:
  /// `heldBack` counts the buffers of the share group whose contents are held back.
  Buffer(GLuint name, SharedCount heldBack);

  /// glBufferData: new contents (null: undefined), held back until the real OpenGL needs them.
  void setData(size_t size, const void* data, GLenum usage);
  /// glBufferSubData within the size.
  void setSubData(size_t offset, size_t size, const void* data);
  /// Whether commands on this range are errors because it overlaps a mapping of our copy.
  bool mappedIn(size_t offset, size_t size) const {
    return mapped() && size > 0 && offset < mapOffset_ + mapLength_ && mapOffset_ < offset + size;
  }
  /// The contents, fetched from the real OpenGL if it has changed them. Null for an empty buffer.
  std::shared_ptr<const BufferStorage> read(const RealGl& real);
  /// The contents, as by read(), for a write to a part of them: does not count as a read by a draw
  /// (isSentOften).
  std::shared_ptr<const BufferStorage> readToWrite(const RealGl& real);
  /// Sends held-back contents to the real OpenGL. Drawing from a mapped buffer is an error: for a mapped
  /// buffer this only allocates memory there, so that a program that draws all the same does no harm.
  void sendTo(const RealGl& real);
  /// Reports that the real OpenGL changes the contents: drops our copy, unless it is mapped.
  void changedBelow();

  /// glMapBuffer(Range) on our copy: a pointer that stays valid until unmap().
  void* map(const RealGl& real, size_t offset, size_t length, GLbitfield access);
  void unmap(const RealGl& real);
  /// If our copy is mapped, maps the real OpenGL's memory, too. The real OpenGL then raises the errors of
  /// commands that may not use mapped buffers. Call before commands that are forwarded unchanged.
  void showMapping(const RealGl& real);

  GLuint name() const { return name_; }
  uint64_t serial() const { return serial_; }  // unlike names and addresses, never reused
  size_t size() const { return size_; }        // bytes
  bool immutable = false;  // by glBufferStorage: the real OpenGL's storage cannot be replaced
  GLenum usage() const { return usage_; }
  bool heldBack() const { return heldBack_; }
  /// Whether new contents were sent several times and never read, so that holding them back is useless.
  bool isSentOften() const { return sent_ >= kOften; }
  /// Bytes that sendTo() has sent since the process began. Any thread.
  static uint64_t bytesSent();
  uint64_t version() const { return version_; }
  bool mapped() const { return mapped_ != nullptr; }
  void* mappedPointer() const { return mapped_; }
  bool showsMapping() const { return shown_ != nullptr; }
  size_t mapOffset() const { return mapOffset_; }
  size_t mapLength() const { return mapLength_; }
  GLbitfield mapAccess() const { return mapAccess_; }
  /// The error of glFlushMappedBufferRange, which only checks its arguments; GL_NO_ERROR: none.
  GLenum flushError(GLintptr offset, GLsizeiptr length) const;

  /// The real OpenGL or the program writes the buffer without GLuRay seeing it (transform feedback, shader
  /// storage, persistent mapping): it is never traced, and each read fetches it anew.
  bool foreign = false;
  bool persistent = false;  // persistently mapped; `foreign` is true, too
  /// The real OpenGL reads the buffer without GLuRay seeing it (uniform blocks, buffer textures, pixels): new
  /// contents are sent at once.
  bool readBelow = false;
  /// Reports that the real OpenGL has new contents of this size: drops our copy.
  void setSizeBelow(size_t size, GLenum usage);
  /// The program has mapped the real OpenGL's memory instead of our copy.
  bool mappedBelow = false;

 private:
  static constexpr int kOften = 3;
  /// Returns storage that may be written; copies it first if a mesh still refers to it.
  BufferStorage& writable();
  void fetch(const RealGl& real);

  std::mutex mutex_;  // guards the members below against contexts that draw from the buffer
  GLuint name_;
  uint64_t serial_;
  std::shared_ptr<BufferStorage> storage_;  // null: the real OpenGL has the only copy
  size_t size_ = 0;
  GLenum usage_ = GL_STATIC_DRAW;
  CountedFlag heldBack_;               // our copy is newer than the real OpenGL's
  std::atomic<int> sent_ = 0;          // times sendTo() has sent since the last read(), up to kOften
  bool memoryBelow_ = false;           // the real OpenGL has memory of this size
  std::atomic<uint64_t> version_ = 1;  // counts changes of content
  void* mapped_ = nullptr;
  std::shared_ptr<BufferStorage> mappedStorage_;  // the storage that mapped_ points into
  size_t mapOffset_ = 0, mapLength_ = 0;
  GLbitfield mapAccess_ = 0;
  void* shown_ = nullptr;  // the mapping of the real OpenGL's memory; null: none
};

}  // namespace gluray::gl
