// Tiles whose eye rays are traced before light: other processes may hide their hits. Part of kernels.cpp
// (compiled once for each instruction set).
#if defined(GLURAY_RENDER_SEEN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SEEN_INL_H_
#undef GLURAY_RENDER_SEEN_INL_H_
#else
#define GLURAY_RENDER_SEEN_INL_H_
#endif

#include "render/kernels/relight.inl.h"
#include "render/tiles/hidden_pixels.h"
#include "render/visibility/multisample.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Last stage: keeps the nearest accepted hits and their depths.
HWY_ATTR inline void keepSeen(const FrameData& frame, const Tile& tile, const GrownSamples& grown, Work& work,
                              CollectedHits& behind) {
  forgetHits(*frame.seen, work);
  clearPixels(frame.image->missColor, work);
  if (frame.grown) pickEdged(frame, grown, work);
  if (frame.leastDepth) pickLeastDepth(frame, centersOf(work), behind, work);
  if (work.hits) shadeNearest(frame, work);
  eachPixel(work, tile, *frame.image,
            [&](size_t at, int i) HWY_ATTR { frame.image->depth[at] = work.depth[i]; });
}

/// Pipelined as traceSamples() is.
HWY_ATTR void traceEyeRays(const FrameData& frame, const Tile& tile) {
  Work works[3];
  CollectedHits behind;
  for (Work& work : works) initPacket(work.packet), work.colors = work.lights = false;
  GrownSamples grown(frame.grown.get(), tile, 2);
  grown.find(0);
  int count = 0;
  const auto back = [&](int stages) HWY_ATTR -> Work& { return works[(count - stages) % 3]; };
  for (int y = tile.y0; y < tile.y1; y += 4) {
    for (int x = tile.x0; x < tile.x1; x += 4, ++count) {
      aim(frame, tile, x, y, 0, back(0));
      traceWork(frame, back(0));
      if (count > 0) fetchVertices(frame, back(1));
      if (count > 1) keepSeen(frame, tile, grown, back(2), behind);
    }
  }
  if (count > 0) fetchVertices(frame, back(1));
  if (count > 1) keepSeen(frame, tile, grown, back(2), behind);
  if (count > 0) keepSeen(frame, tile, grown, back(1), behind);
}

/// The lanes of a packet whose pixels are hidden: lanes are in Z order of 2x2 quads.
HWY_ATTR inline uint16_t hiddenLanes(const HiddenPixels& hidden, int x, int y) {
  const uint32_t block = hidden.block(x, y);
  if (!block) return 0;
  uint32_t lanes = 0;
  for (int i = 0; i < kLanes; ++i) lanes |= (block >> (4 * laneY(i) + laneX(i)) & 1) << i;
  return static_cast<uint16_t>(lanes);
}

/// The points of hits that are not hidden, for their visibility.
HWY_ATTR inline void collectKept(const FrameData& frame, const HitBuffer::Lanes& kept, Work& work) {
  work.edged = kept.edged, work.colors = false;
  shadeHits(frame, work.hits & ~uint32_t{kept.hidden}, false, work,
            [](uint32_t, const LitRows&, const float*) HWY_ATTR {});
}

HWY_ATTR void lightSeen(const FrameData& frame, const Tile& tile, const HiddenPixels& hidden,
                        WaitingPoints* waiting) {
  HitBuffer& buffer = *frame.seen;
  Work work;
  work.waiting = waiting;
  eachKeptPacket(frame, buffer, tile, work, [&]() HWY_ATTR {
    HitBuffer::Lanes& kept = buffer.lanes[buffer.at(work.imageX, work.imageY)];
    kept.hidden = hiddenLanes(hidden, work.imageX - tile.x0, work.imageY - tile.y0);
    if (frame.collector) {
      if (work.hits) collectKept(frame, kept, work);
      return;
    }
    clearPixels(frame.image->missColor, work);
    if (work.hits) showKept(frame, kept, work);
    storePixels(work, tile, *frame.image);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
