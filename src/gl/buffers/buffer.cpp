#include "gl/buffers/buffer.h"

#include "gl/real/extensions.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace gluray::gl {
namespace {

std::atomic<uint64_t> g_bytesSent{0};

}  // namespace

BufferStorage::BufferStorage(size_t sizeBytes)
    : data(static_cast<std::byte*>(
          std::aligned_alloc(kAlignment, (sizeBytes + 16 + kAlignment - 1) / kAlignment * kAlignment))),
      size(sizeBytes) {
  if (!data) throw std::bad_alloc();
  std::memset(data + size, 0, 16);
}

BufferStorage::~BufferStorage() { std::free(data); }

Buffer::Buffer(GLuint name, SharedCount heldBack) : name_(name), heldBack_(std::move(heldBack)) {
  static std::atomic<uint64_t> next{1};
  serial_ = next++;
}

void Buffer::setData(size_t size, const void* data, GLenum usage) {
  auto storage = std::make_shared<BufferStorage>(size);
  if (data) std::memcpy(storage->data, data, size);
  const std::lock_guard lock(mutex_);
  storage_ = std::move(storage);
  size_ = size;
  usage_ = usage;
  heldBack_ = true;
  mapped_ = nullptr;
  shown_ = nullptr;  // replacing the real OpenGL's contents ends this mapping
  mappedStorage_.reset();
  memoryBelow_ = false;
  ++version_;
}

BufferStorage& Buffer::writable() {
  // Drawing from storage mapped for writing is an error, so that writes to its other bytes can be in place,
  // too.
  const bool shared = mapped_ && mappedStorage_ == storage_ && (mapAccess_ & GL_MAP_WRITE_BIT);
  if (storage_.use_count() > 1 && !shared) {
    auto copy = std::make_shared<BufferStorage>(size_);
    std::memcpy(copy->data, storage_->data, size_);
    storage_ = std::move(copy);
  } else {
    // Acquires: a mesh that another thread has released has finished reading before we write.
    const std::shared_ptr<BufferStorage> acquired = storage_;
  }
  heldBack_ = true;
  ++version_;
  return *storage_;
}

void Buffer::setSubData(size_t offset, size_t size, const void* data) {
  const std::lock_guard lock(mutex_);
  std::memcpy(writable().data + offset, data, size);
}

namespace {

/// Binds a buffer, during its lifetime, to a target that draws do not use; since OpenGL 3.1 to one that
/// hardly any program uses. The previous buffer is bound again by name, which fails if another context has
/// deleted it.
class CopyBinding {
 public:
  CopyBinding(const RealGl& real, GLuint name)
      : real_(real), target_(versionOf(real) >= 31 ? GL_COPY_WRITE_BUFFER : GL_ARRAY_BUFFER) {
    real.GetIntegerv(target_ == GL_ARRAY_BUFFER ? GL_ARRAY_BUFFER_BINDING : GL_COPY_WRITE_BUFFER_BINDING,
                     &saved_);
    real.BindBuffer(target_, name);
  }
  ~CopyBinding() { real_.BindBuffer(target_, static_cast<GLuint>(saved_)); }
  CopyBinding(const CopyBinding&) = delete;
  CopyBinding& operator=(const CopyBinding&) = delete;
  GLenum target() const { return target_; }

 private:
  const RealGl& real_;
  GLenum target_;
  GLint saved_ = 0;
};

/// Size in bytes of the buffer bound to `target`.
size_t sizeBelow(const RealGl& real, GLenum target) {
  GLint size = 0;
  GLint64 large = 0;  // GL_INT holds sizes below 2 GiB
  if (versionOf(real) >= 32 && isPresent(real.GetBufferParameteri64v))
    real.GetBufferParameteri64v(target, GL_BUFFER_SIZE, &large);
  else
    real.GetBufferParameteriv(target, GL_BUFFER_SIZE, &size), large = size;
  return static_cast<size_t>(std::max<GLint64>(large, 0));
}

}  // namespace

void Buffer::fetch(const RealGl& real) {
  if (mappedBelow) {  // cannot be read; drawing from it is an error: zeros draw nothing
    storage_ = std::make_shared<BufferStorage>(size_);
    std::memset(storage_->data, 0, size_);
    return;
  }
  const CopyBinding binding(real, name_);
  size_ = sizeBelow(real, binding.target());  // commands that GLuRay does not model may have set it
  if (size_ == 0) return;
  auto storage = std::make_shared<BufferStorage>(size_);
  real.GetBufferSubData(binding.target(), 0, static_cast<GLsizeiptr>(size_), storage->data);
  storage_ = std::move(storage);
}

std::shared_ptr<const BufferStorage> Buffer::read(const RealGl& real) {
  sent_ = 0;
  return readToWrite(real);
}

std::shared_ptr<const BufferStorage> Buffer::readToWrite(const RealGl& real) {
  const std::lock_guard lock(mutex_);
  if (!storage_ || (foreign && !heldBack_ && !mapped_)) fetch(real);
  return storage_;
}

uint64_t Buffer::bytesSent() { return g_bytesSent.load(std::memory_order_relaxed); }

void Buffer::sendTo(const RealGl& real) {
  if (!heldBack_) return;
  const std::lock_guard lock(mutex_);
  if (!heldBack_ || (mapped_ && memoryBelow_)) return;
  const CopyBinding binding(real, name_);
  // A mapped buffer gets memory too, because some drivers read at null when a program draws from it.
  real.BufferData(binding.target(), static_cast<GLsizeiptr>(size_), mapped_ ? nullptr : storage_->data,
                  usage_);
  if (!mapped_) {
    g_bytesSent.fetch_add(size_, std::memory_order_relaxed);
    sent_ = std::min(sent_ + 1, kOften);
  }
  memoryBelow_ = true;
  heldBack_ = mapped_ != nullptr;
}

void Buffer::changedBelow() {
  const std::lock_guard lock(mutex_);
  if (mapped_) return;
  storage_.reset();
  ++version_;
}

void Buffer::setSizeBelow(size_t size, GLenum usage) {
  const std::lock_guard lock(mutex_);
  size_ = size, usage_ = usage, heldBack_ = false, mapped_ = shown_ = nullptr;
  storage_.reset(), mappedStorage_.reset();
  ++version_;
}

void* Buffer::map(const RealGl& real, size_t offset, size_t length, GLbitfield access) {
  const std::lock_guard lock(mutex_);
  if (!storage_ && size_ > 0) fetch(real);
  if (!storage_) storage_ = std::make_shared<BufferStorage>(size_);
  std::byte* data = (access & GL_MAP_WRITE_BIT) ? writable().data : storage_->data;
  mapped_ = data + offset;
  mappedStorage_ = storage_;
  mapOffset_ = offset, mapLength_ = length, mapAccess_ = access;
  return mapped_;
}

GLenum Buffer::flushError(GLintptr offset, GLsizeiptr length) const {
  if (offset < 0 || length < 0) return GL_INVALID_VALUE;
  if (!(mapAccess_ & GL_MAP_FLUSH_EXPLICIT_BIT)) return GL_INVALID_OPERATION;
  const auto first = static_cast<size_t>(offset), count = static_cast<size_t>(length);
  return first > mapLength_ || count > mapLength_ - first ? GL_INVALID_VALUE : GL_NO_ERROR;
}

void Buffer::showMapping(const RealGl& real) {
  const std::lock_guard lock(mutex_);
  if (!mapped_ || shown_) return;
  const CopyBinding binding(real, name_);
  if (heldBack_) real.BufferData(binding.target(), static_cast<GLsizeiptr>(size_), storage_->data, usage_);
  shown_ = real.MapBufferRange(binding.target(), static_cast<GLintptr>(mapOffset_),
                               static_cast<GLsizeiptr>(mapLength_),
                               mapAccess_ & (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT));
  memoryBelow_ = true;
}

void Buffer::unmap(const RealGl& real) {
  const std::lock_guard lock(mutex_);
  if (void* const below = std::exchange(shown_, nullptr)) {  // its contents may differ by now
    if (mapAccess_ & GL_MAP_WRITE_BIT) std::memcpy(below, mapped_, mapLength_);
    const CopyBinding binding(real, name_);
    real.UnmapBuffer(binding.target());
    mapped_ = nullptr, heldBack_ = false, ++version_;
    storage_.reset(), mappedStorage_.reset();
    return;
  }
  if (mapAccess_ & GL_MAP_WRITE_BIT) heldBack_ = true, ++version_;
  mapped_ = nullptr;
  mappedStorage_.reset();
}

}  // namespace gluray::gl
