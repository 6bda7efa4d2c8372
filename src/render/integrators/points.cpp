#include "render/integrators/points.h"

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/integrators/points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/integrators/points.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

HWY_ATTR void fillAskedPoints(const Metric& metric, const FrameData& frame, const ColoredHits& hits,
                              AskedPoints& out) {
  makePoints(metric, frame, hits, out.points);
  out.lanes = hits.group.lanes, out.sample = hits.sample, out.share = hits.share;
  std::copy_n(hits.x, kLanes, out.x), std::copy_n(hits.y, kLanes, out.y);
  std::fill_n(out.instance, kLanes, hits.instance);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(fillAskedPoints);

void askedPointsOf(const Metric& metric, const FrameData& frame, const ColoredHits& hits, AskedPoints& out) {
  HWY_DYNAMIC_DISPATCH(fillAskedPoints)(metric, frame, hits, out);
}

}  // namespace gluray::render
#endif
