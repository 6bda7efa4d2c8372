// Monotonic time, for reports and benchmarks. Any thread.
#pragma once
#include <chrono>

namespace gluray {

/// Seconds since an arbitrary start, never going back.
inline double nowSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace gluray
