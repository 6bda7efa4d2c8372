// Shortens rays to where the framebuffer has surfaces. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_KNOWN_DEPTHS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_KNOWN_DEPTHS_INL_H_
#undef GLURAY_RENDER_KNOWN_DEPTHS_INL_H_
#else
#define GLURAY_RENDER_KNOWN_DEPTHS_INL_H_
#endif

#include "render/frame_data/known_depths.h"
#include "render/packets/work.inl.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The framebuffer's depths at a packet's pixels; no numbers outside of what is known. Prefetches those of
/// the packets that follow in its row.
HWY_ATTR inline void depthsAt(const scene::FramebufferCapture& capture, const Work& work, Row& depth) {
  constexpr int kAhead = 32;  // pixels
  const scene::Region& r = capture.region;
  const auto width = static_cast<size_t>(r.width);
  for (int y = work.imageY; y < std::min(work.imageY + 4, r.height) && work.imageX + kAhead < r.width; ++y)
    hwy::Prefetch(
        &capture.depths[static_cast<size_t>(y) * width + static_cast<size_t>(work.imageX + kAhead)]);
  if (work.imageX + 4 <= r.width && work.imageY + 4 <= r.height) {
    const float* first =
        capture.depths.data() + static_cast<size_t>(work.imageY) * width + static_cast<size_t>(work.imageX);
    for (int i = 0; i < kLanes; i += 2)
      std::memcpy(depth + i, first + static_cast<size_t>(laneY(i)) * width + static_cast<size_t>(laneX(i)),
                  2 * sizeof *first);
    return;
  }
  for (int i = 0; i < kLanes; ++i) {
    const int x = work.imageX + laneX(i), y = work.imageY + laneY(i);
    depth[i] = x < r.width && y < r.height
                   ? capture.depths[static_cast<size_t>(y) * width + static_cast<size_t>(x)]
                   : std::numeric_limits<float>::quiet_NaN();
  }
}

/// Shortens a packet's rays to where the framebuffer has surfaces. `valid` becomes 0 where it has none, at
/// the depth of its clear. Not inline: images without known depths need it not.
HWY_ATTR HWY_NOINLINE inline void shortenRays(const KnownDepths& known, Work& work,
                                              int32_t (&valid)[kLanes]) {
  const DoubleTag d;
  const HalfTag half;
  const hn::RebindToSigned<HalfTag> di;
  const auto one = hn::Set(d, 1.0);
  constexpr double kFarAway = std::numeric_limits<float>::max();
  alignas(64) Row depths;
  depthsAt(*known.capture, work, depths);
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    const auto k =
        hn::Mul(hn::Sub(loadDouble(depths + i), hn::Set(d, known.depthNear)), hn::Set(d, known.perDepth));
    const auto w = hn::MulAdd(k, hn::Set(d, known.growth), one);
    const auto inverse = hn::Div(one, w), t = hn::Mul(hn::Mul(k, inverse), hn::Set(d, known.perScale));
    const auto reach = hn::MulAdd(hn::Mul(inverse, inverse), hn::Set(d, known.steps),
                                  hn::MulAdd(t, hn::Set(d, known.rounding), hn::Set(d, known.reach)));
    // Rays stay whole where there is no number, or where it is behind the viewer.
    const auto usable = hn::Gt(w, hn::Zero(d));
    const auto nearest = hn::IfThenElse(usable, hn::Sub(t, reach), hn::Set(d, -kFarAway));
    const auto farthest = hn::IfThenElse(usable, hn::Add(t, reach), hn::Set(d, kFarAway));
    const auto from = hn::Max(hn::Load(half, work.packet.tNear + i), hn::DemoteTo(half, nearest));
    const auto to = hn::Min(hn::Load(half, work.packet.tFar + i), hn::DemoteTo(half, farthest));
    hn::Store(from, half, work.packet.tNear + i), hn::Store(to, half, work.packet.tFar + i);
    const auto clear = hn::Ge(hn::Load(half, depths + i), hn::Set(half, known.clear));
    const auto nothing = hn::Or(clear, hn::Gt(from, to));
    const auto before = hn::Load(di, work.valid + i);
    hn::Store(hn::IfThenZeroElse(hn::RebindMask(di, nothing), before), di, valid + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
