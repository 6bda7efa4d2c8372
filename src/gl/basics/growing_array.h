// Growable array of millions of trivially copyable values: uninitialised, grown by mremap. Any thread.
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>

namespace gluray::gl {

/// Resizes `memory` of `oldBytes` (null: 0) to `newBytes` and keeps its contents. Returns null for 0 bytes,
/// and null with nothing changed if there is no memory. Blocks of 1 MiB and more are mmapped: their pages are
/// moved instead of copied, and returned to the system at once.
void* resizeBlock(void* memory, size_t oldBytes, size_t newBytes) noexcept;
void freeBlock(void* memory, size_t bytes) noexcept;
/// Throws std::bad_alloc.
[[noreturn]] void throwNoMemory();

/// Growable array. kSlackBytes beyond the capacity can be written and read too, for wide copies and Embree's
/// wide loads. clear() keeps the memory. Throws std::bad_alloc.
template <class T>
class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  static constexpr size_t kSlackBytes = 64;

  GrowingArray() = default;
  GrowingArray(GrowingArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  GrowingArray& operator=(GrowingArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  ~GrowingArray() { freeBlock(data_, bytesFor(capacity_)); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  size_t size() const { return size_; }
  size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }
  T& operator[](size_t i) { return data_[i]; }
  const T& operator[](size_t i) const { return data_[i]; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }

  /// Makes room for `count` elements and keeps existing ones.
  void reserve(size_t count) {
    if (count > capacity_) reallocate(count);
  }
  /// Sets the size; new elements have no values yet.
  void resize(size_t count) {
    reserve(count);
    size_ = count;
  }
  /// Sets the size, with spare room for further growth.
  void grow(size_t count) {
    if (count > capacity_) reallocate(count + count / 2);
    size_ = count;
  }
  void clear() { size_ = 0; }
  /// Reduces the capacity to `count`, at least size(). Keeps the memory if that fails.
  void shrink(size_t count) noexcept {
    if (count >= capacity_) return;
    if (count == 0) return release();
    if (void* less = resizeBlock(data_, bytesFor(capacity_), bytesFor(count)))
      data_ = static_cast<T*>(less), capacity_ = count;
  }
  void release() {
    freeBlock(data_, bytesFor(capacity_));
    data_ = nullptr;
    size_ = capacity_ = 0;
  }

 private:
  static size_t bytesFor(size_t count) { return count ? count * sizeof(T) + kSlackBytes : 0; }
  void reallocate(size_t count) {
    void* grown = resizeBlock(data_, bytesFor(capacity_), bytesFor(count));
    if (!grown) throwNoMemory();
    data_ = static_cast<T*>(grown);
    capacity_ = count;
  }

  T* data_ = nullptr;
  size_t size_ = 0, capacity_ = 0;
};

}  // namespace gluray::gl
