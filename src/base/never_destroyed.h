// Static objects that are never destroyed, because programs call GLuRay, and threads trace, while the process
// exits. Any thread.
#pragma once
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace gluray {

/// A static object. Its construction allocates only what T's constructor allocates, so that functions that
/// must not throw can construct it when memory has run out.
template <class T>
class NeverDestroyed {
 public:
  NeverDestroyed() noexcept(std::is_nothrow_default_constructible_v<T>) {
    std::construct_at(reinterpret_cast<T*>(room_));
  }
  NeverDestroyed(const NeverDestroyed&) = delete;
  NeverDestroyed& operator=(const NeverDestroyed&) = delete;
  T& operator*() noexcept { return *std::launder(reinterpret_cast<T*>(room_)); }

 private:
  alignas(T) std::byte room_[sizeof(T)];
};

}  // namespace gluray
