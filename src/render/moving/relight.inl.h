// The second pass over a moving frame: colours the hits that the first one kept, whose factors of light are
// smooth by now. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_RELIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RELIGHT_INL_H_
#undef GLURAY_RENDER_RELIGHT_INL_H_
#else
#define GLURAY_RENDER_RELIGHT_INL_H_
#endif

#include "render/moving/filter.h"
#include "render/moving/kept_hits.inl.h"
#include "render/pixels.inl.h"
#include "render/trace.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Last stage: colours the hits and writes the pixels.
HWY_ATTR inline void relightWork(const FrameData& frame, const Tile& tile, const TileFactors& factors,
                                 Work& work) {
  clearPixels(frame.image->missColor, work);
  if (work.hits) {
    work.edged = frame.moving->hits->lanes[frame.moving->hits->at(work.imageX, work.imageY)].edged;
    work.factors = &factors.at(work.imageX - tile.x0, work.imageY - tile.y0);
    const bool wide = frame.image->has(Plane::wideColor);
    shadeHits(frame, work.hits, false, work,
              [&](uint32_t lanes, const LitRows& rows, const float* depth)
                  HWY_ATTR { mergeShown(lanes, rows, depth, wide, work); });
  }
  if (frame.lamps) showLamps(frame, work);
  storePixels(work, tile, *frame.image);
}

/// Pipelined as the first pass is.
HWY_ATTR void relightTile(const FrameData& frame, const Tile& tile, const TileFactors& factors) {
  Work works[3];
  for (Work& work : works) initPacket(work.packet);
  int count = 0;
  const auto back = [&](int stages) HWY_ATTR -> Work& { return works[(count - stages) % 3]; };
  for (int y = tile.y0; y < tile.y1; y += 4) {
    for (int x = tile.x0; x < tile.x1; x += 4, ++count) {
      aim(frame, tile, x, y, 0, back(0));
      recall(*frame.moving->hits, back(0));
      prefetchTriangles(frame, back(0));
      if (count > 0) fetchVertices(frame, back(1));
      if (count > 1) relightWork(frame, tile, factors, back(2));
    }
  }
  if (count > 0) fetchVertices(frame, back(1));
  if (count > 1) relightWork(frame, tile, factors, back(2));
  if (count > 0) relightWork(frame, tile, factors, back(1));
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
