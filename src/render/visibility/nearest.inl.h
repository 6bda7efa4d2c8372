// Chooses the triangle that OpenGL's depth test leaves at a pixel. Part of kernels.cpp (compiled once for
// each instruction set).
#if defined(GLURAY_RENDER_NEAREST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_NEAREST_INL_H_
#undef GLURAY_RENDER_NEAREST_INL_H_
#else
#define GLURAY_RENDER_NEAREST_INL_H_
#endif

#include "render/packets/trace.inl.h"

#include <tuple>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The nearest triangle at a lane's pixel so far.
struct Nearest {
  double depth = HUGE_VAL;  // window, not clamped
  uint32_t instance = accel::kNoHit, primitive = 0;
};

/// Whether OpenGL's depth test prefers `next` to `best`. If the depth buffer rounds both depths to one step,
/// the order of drawing decides.
HWY_ATTR inline bool isSeenBefore(const FrameData& frame, const Nearest& next, const Nearest& best) {
  if (best.instance == accel::kNoHit) return true;
  const double depth = std::clamp(next.depth, 0.0, 1.0), bestDepth = std::clamp(best.depth, 0.0, 1.0);
  const double step = frame.snapshot->polygonOffset.resolution;
  if (std::abs(depth - bestDepth) > step) return depth < bestDepth;
  const double steps = std::round(depth / step), bestSteps = std::round(bestDepth / step);
  if (steps != bestSteps) return steps < bestSteps;
  const bool later = std::tie(next.instance, next.primitive) > std::tie(best.instance, best.primitive);
  return later == frame.snapshot->laterWins;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
