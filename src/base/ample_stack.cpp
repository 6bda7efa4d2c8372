#include "base/ample_stack.h"

#include "base/processes/own_thread.h"

#include <pthread.h>

#include <cstdint>
#include <exception>
#include <limits>
#include <new>

namespace gluray {
namespace {

/// Addresses of a thread's stack; both 0: not read yet.
struct Bounds {
  uintptr_t low = 0, high = 0;
};

Bounds readBounds() noexcept {
  constexpr Bounds kUnknown{0, std::numeric_limits<uintptr_t>::max()};
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return kUnknown;
  void* low = nullptr;
  size_t size = 0;
  const bool known = pthread_attr_getstack(&attributes, &low, &size) == 0 && low && size > 0;
  pthread_attr_destroy(&attributes);
  const auto start = reinterpret_cast<uintptr_t>(low);
  return known ? Bounds{start, start + size} : kUnknown;
}

}  // namespace

size_t stackLeft() noexcept {
  thread_local Bounds bounds;
  if (bounds.high == 0) bounds = readBounds();
  const auto here = reinterpret_cast<uintptr_t>(__builtin_frame_address(0));
  if (here < bounds.low || here >= bounds.high) return 0;
  return bounds.low == 0 ? std::numeric_limits<size_t>::max() : here - bounds.low;
}

namespace {

struct Call {
  void (*work)(void*);
  void* object;
  std::exception_ptr thrown;

  static void* run(void* call) noexcept {
    auto& self = *static_cast<Call*>(call);
    try {
      self.work(self.object);
    } catch (...) { self.thrown = std::current_exception(); }
    return nullptr;
  }
};

}  // namespace

void callOnOwnStack(void (*work)(void* object), void* object) {
  Call call{work, object, nullptr};
  pthread_t thread;
  if (!startThread(thread, Call::run, &call)) throw std::bad_alloc();
  pthread_join(thread, nullptr);
  if (call.thrown) std::rethrow_exception(call.thrown);
}

}  // namespace gluray
