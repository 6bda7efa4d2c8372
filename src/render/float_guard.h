// The host program's floating-point settings, put aside while we compute. Any thread.
#pragma once
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace gluray::render {

/// Masks floating-point exceptions and flushes denormals while it lives: a host may have set traps that our
/// misses (infinite distances) would spring, and Embree is slow on denormals.
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
