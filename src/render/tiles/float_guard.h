// Saves and restores the host program's floating-point settings around our computations. Any thread.
#pragma once
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace gluray::render {

/// During its lifetime, masks floating-point exceptions and flushes denormals: our infinite distances would
/// trigger traps that a host has enabled, and Embree is slow with denormals.
class FloatGuard {
#if defined(__SSE__)
 public:
  FloatGuard() : saved_(_mm_getcsr()) { _mm_setcsr(kMaskedRoundNearest | kFlushDenormals); }
  ~FloatGuard() { _mm_setcsr(saved_); }
  FloatGuard(const FloatGuard&) = delete;
  FloatGuard& operator=(const FloatGuard&) = delete;

 private:
  static constexpr unsigned kMaskedRoundNearest = 0x1F80, kFlushDenormals = 0x8040;
  unsigned saved_;
#else
 public:
  FloatGuard() {}
  FloatGuard(const FloatGuard&) = delete;
  FloatGuard& operator=(const FloatGuard&) = delete;
#endif
};

}  // namespace gluray::render
