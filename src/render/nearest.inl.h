// Which of several triangles OpenGL's depth test leaves at a pixel. Part of kernels.cpp (compiled once for
// each instruction set).
#if defined(GLURAY_RENDER_NEAREST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_NEAREST_INL_H_
#undef GLURAY_RENDER_NEAREST_INL_H_
#else
#define GLURAY_RENDER_NEAREST_INL_H_
#endif

#include "render/trace.inl.h"

#include <tuple>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// What is seen at a lane's pixel so far.
struct Nearest {
  double step = HUGE_VAL;  // of the depth buffer
  uint32_t instance = accel::kNoHit, primitive = 0;
};

/// The step of the depth buffer that a window depth is rounded to.
inline double stepOf(const FrameData& frame, double depth) {
  return std::round(std::clamp(depth, 0.0, 1.0) / frame.snapshot->polygonOffset.resolution);
}

/// Whether OpenGL's depth test prefers a triangle to the nearest so far. At equal depths the order of drawing
/// decides.
inline bool isSeenBefore(const FrameData& frame, const Nearest& next, const Nearest& best) {
  if (best.instance == accel::kNoHit) return true;
  if (next.step != best.step) return next.step < best.step;
  const bool later = std::tie(next.instance, next.primitive) > std::tie(best.instance, best.primitive);
  return later == frame.snapshot->laterWins;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
