// Memory that processes of one machine share and nobody can change any more: arrays go from the program to
// workers without another copy. Any thread.
#pragma once
#include "dist/stream/arrays.h"

#include <cstddef>
#include <functional>

namespace gluray::dist {

/// A file descriptor that is closed with it.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) reset(), number_ = other.release();
    return *this;
  }
  explicit operator bool() const { return number_ >= 0; }
  int get() const { return number_; }
  int release() {
    const int number = number_;
    number_ = -1;
    return number;
  }
  void reset();

 private:
  int number_ = -1;
};

/// New memory of `bytes` bytes and kArrayPadding zeros, which `fill` writes; sealed afterwards. Throws
/// std::system_error where there is none.
Descriptor sealedMemory(size_t bytes, const std::function<void(std::byte*)>& fill);

/// Maps memory that another process has sealed. Throws Malformed where it is not sealed, because its sender
/// could change it while it is read, or cut it off, or where it does not hold `bytes` bytes;
/// std::system_error.
Array mapSealed(const Descriptor& memory, size_t bytes);

}  // namespace gluray::dist
