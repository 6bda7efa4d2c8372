#include "render/moving/collector.h"

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/moving/collector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/integrators/points.inl.h"
#include "render/moving/history.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Lanes that trace rays in this frame.
HWY_ATTR inline uint32_t tracedLanes(const MovingFrame& moving, uint32_t lanes, const Known& known) {
  if (moving.rays.perPixel == 0) return 0;
  if (!moving.rays.quarter || moving.mostLightSamples == 0) return lanes;
  constexpr uint32_t kOneOfEachQuad = 0x1111;
  constexpr uint32_t kTurns[] = {0, 3, 1, 2};
  uint32_t traced = kOneOfEachQuad << kTurns[moving.index & 3];
  for (int i = 0; i < kLanes; ++i)
    if (known.samples[i] == 0) traced |= 1u << i;
  return traced & lanes;
}

/// Indices of the packet's pixels in the buffer.
HWY_ATTR inline void pixelsOf(const MovingFrame& moving, const ColoredHits& hits, const scene::Region& region,
                              uint32_t (&pixels)[kLanes]) {
  const IntTag d;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Ints x = hn::ConvertTo(d, hn::Sub(load(hits.x + i), splat(static_cast<float>(region.x)))),
               y = hn::ConvertTo(d, hn::Sub(load(hits.y + i), splat(static_cast<float>(region.y))));
    const Ints at = hn::Add(hn::Mul(y, hn::Set(d, moving.visibility->width)), x);
    hn::Store(hn::BitCast(WordTag(), at), WordTag(), pixels + i);
  }
}

/// Puts the surfaces and what is known of them into the buffer.
HWY_ATTR inline void storePixels(const MovingFrame& moving, uint32_t lanes, const uint32_t (&pixels)[kLanes],
                                 const SurfacePoints& points, const Known& known) {
  VisibilityBuffer& buffer = *moving.visibility;
  const PixelSpace& space = moving.space;
  alignas(64) uint32_t word0[kLanes], word1[kLanes];
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float depth =
        hn::Add(dot(splat(glm::vec3(space.depth)), load3(points.eye, i)), splat(space.depth.w));
    const Float second =
        buffer.channels > 1 ? load(moving.channels.rowOf(known.visibility, 1) + i) : splat(0);
    const VisibilityPixels packed{depth, load(known.samples + i),
                                  load(moving.channels.rowOf(known.visibility, 0) + i), second,
                                  load3(points.shading, i)};
    hn::Store(packed.word0(), WordTag(), word0 + i), hn::Store(packed.word1(), WordTag(), word1 + i);
  }
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    buffer.words[2 * size_t{pixels[i]}] = word0[i], buffer.words[2 * size_t{pixels[i]} + 1] = word1[i];
    for (int f = 2; f < buffer.channels; ++f)
      buffer.setMore(f, pixels[i], moving.channels.rowOf(known.visibility, f)[i]);
  }
}

/// Traces the rays of the points that wait, and adds their samples to what is known.
HWY_ATTR void traceWaiting(const Collector& c, WaitingPoints& waiting) {
  const MovingFrame& moving = c.moving;
  VisibilityBuffer& buffer = *moving.visibility;
  waiting.asked.lanes = (1u << waiting.count) - 1;
  Visibility fresh{};
  c.integrator.estimate(waiting.asked, fresh);
  alignas(64) uint32_t first[kLanes], second[kLanes] = {};
  const Float added = splat(static_cast<float>(moving.rays.perPixel));
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float before = load(waiting.samples + i), sum = hn::Add(before, added);
    for (int f = 0; f < buffer.channels; ++f) {
      const Float kept = hn::Min(before, splat(moving.mostSamplesOf(f)));
      const Float share = hn::Div(added, hn::Add(kept, added));
      const Float old = load(waiting.visibility[f] + i), now = load(moving.channels.rowOf(fresh, f) + i);
      store(hn::MulAdd(share, hn::Sub(now, old), old), waiting.visibility[f] + i);
    }
    const Words samples = toWord(hn::Min(sum, splat(static_cast<float>(VisibilityBuffer::kMaxSamples))));
    hn::Store(packVisibility(load(waiting.visibility[0] + i)), WordTag(), first + i);
    const Words other =
        buffer.channels > 1 ? packVisibility(load(waiting.visibility[1] + i)) : hn::Zero(WordTag());
    hn::Store(hn::Or(hn::ShiftLeft<12>(samples), other), WordTag(), second + i);
  }
  for (int i = 0; i < waiting.count; ++i) {
    const uint32_t pixel = waiting.pixel[i];
    uint32_t* words = buffer.words.data() + 2 * size_t{pixel};
    words[0] = (words[0] & ~VisibilityBuffer::kVisibilityBits) | first[i];
    words[1] = (words[1] & VisibilityBuffer::kNormalBits) | second[i];
    for (int f = 2; f < buffer.channels; ++f) buffer.setMore(f, pixel, waiting.visibility[f][i]);
  }
  waiting.count = 0;
}

/// Lets a lane's point wait; traces it and those that wait already once they fill a packet.
HWY_ATTR inline void wait(const Collector& c, const ColoredHits& hits, const SurfacePoints& points,
                          const Known& known, uint32_t pixel, int lane, WaitingPoints& to) {
  const int at = to.count++;
  for (int axis = 0; axis < 3; ++axis) {
    to.asked.points.origin[axis][at] = points.origin[axis][lane];
    to.asked.points.eye[axis][at] = points.eye[axis][lane];
    to.asked.points.geometric[axis][at] = points.geometric[axis][lane];
    to.asked.points.shading[axis][at] = points.shading[axis][lane];
  }
  to.asked.points.lift[at] = points.lift[lane];
  to.asked.points.turned[at] = points.turned[lane];
  to.asked.x[at] = hits.x[lane], to.asked.y[at] = hits.y[lane];
  to.asked.instance[at] = hits.instance, to.asked.place[at] = static_cast<uint32_t>(lane);
  to.pixel[at] = pixel, to.samples[at] = known.samples[lane];
  for (int f = 0; f < c.moving.visibility->channels; ++f)
    to.visibility[f][at] = c.moving.channels.rowOf(known.visibility, f)[lane];
  if (to.count == kLanes) traceWaiting(c, to);
}

HWY_ATTR void collect(const Collector& c, const ColoredHits& hits) {
  SurfacePoints points;
  makePoints(c.metric, c.frame, hits, points);
  Known known;
  if (c.moving.earlier && c.moving.reprojection.stayed(hits.instance)) {
    NarrowLanes narrow;
    findNarrow(c.frame, c.moving.space, hits, points, narrow);
    lookUp(c.moving, points.eye, points.shading, narrow, known);
  } else {
    for (float& samples : known.samples) samples = 0;
    for (int f = 0; f < c.moving.channels.count(); ++f)
      std::fill_n(c.moving.channels.rowOf(known.visibility, f), kLanes, 0.0f);
  }
  alignas(64) uint32_t pixels[kLanes];
  pixelsOf(c.moving, hits, c.frame.snapshot->region, pixels);
  storePixels(c.moving, hits.group.lanes, pixels, points, known);
  for (uint32_t lanes = tracedLanes(c.moving, hits.group.lanes, known); lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    wait(c, hits, points, known, pixels[i], i, *hits.waiting);
  }
}

HWY_ATTR void finishWaiting(const Collector& c, WaitingPoints& waiting) {
  if (waiting.count) traceWaiting(c, waiting);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(collect);
HWY_EXPORT(finishWaiting);

void Collector::light(const ColoredHits& hits, ColorRows&) const noexcept {
  HWY_DYNAMIC_DISPATCH(collect)(*this, hits);
}

void Collector::finish(WaitingPoints& waiting) const noexcept {
  HWY_DYNAMIC_DISPATCH(finishWaiting)(*this, waiting);
}

}  // namespace gluray::render
#endif
