// The second pass over a moving frame: colours the hits that the first one kept, whose visibility is smooth
// by now. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_RELIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RELIGHT_INL_H_
#undef GLURAY_RENDER_RELIGHT_INL_H_
#else
#define GLURAY_RENDER_RELIGHT_INL_H_
#endif

#include "render/kernels/kept_packets.inl.h"
#include "render/moving/filter.h"
#include "render/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Puts the hits of a packet into its pixels: with light, except those that another process hides.
HWY_ATTR inline void showKept(const FrameData& frame, const HitBuffer::Lanes& kept, Work& work) {
  const bool wide = frame.image->has(Plane::wideColor);
  const auto take = [&](uint32_t lanes, const LitRows& rows, const float* depth)
                        HWY_ATTR { mergeShown(lanes, rows, depth, wide, work); };
  const uint32_t hidden = kept.hidden & work.hits;
  work.edged = kept.edged;
  shadeHits(frame, work.hits & ~hidden, false, work, take);
  if (!hidden) return;
  work.visibility = nullptr, work.lights = false;
  shadeHits(frame, hidden, false, work, take);
  work.lights = true;
}

/// Last stage: colours the hits and writes the pixels.
HWY_ATTR inline void relightWork(const FrameData& frame, const Tile& tile, const TileVisibility& visibility,
                                 Work& work) {
  clearPixels(frame.image->missColor, work);
  if (work.hits) {
    work.visibility = &visibility.at(work.imageX - tile.x0, work.imageY - tile.y0);
    showKept(frame, frame.moving->hits->lanes[frame.moving->hits->at(work.imageX, work.imageY)], work);
  }
  if (frame.lamps) showLamps(frame, work);
  storePixels(work, tile, *frame.image);
}

/// Opacities of a packet's hits that take only occlusion from the framebuffer, as colours: black.
HWY_ATTR inline void packOcclusion(const Row& open, float strength, uint32_t (&color)[kLanes]) {
  const IndexTag d;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float taken = clamp01(hn::Mul(splat(strength), hn::Sub(splat(1), load(open + i))));
    const auto alpha = hn::BitCast(d, hn::NearestInt(hn::Mul(taken, splat(255))));
    hn::Store(hn::ShiftLeft<24>(alpha), d, color + i);
  }
}

/// Last stage of such hits. The image has their depths.
HWY_ATTR inline void showOcclusion(const Tile& tile, const TileVisibility& visibility, float strength,
                                   Image& image) {
  const auto width = static_cast<size_t>(image.width);
  alignas(64) uint32_t color[kLanes];
  for (int y = tile.y0; y < tile.y1; y += 4) {
    for (int x = tile.x0; x < tile.x1; x += 4) {
      packOcclusion(visibility.at(x - tile.x0, y - tile.y0).occlusion, strength, color);
      const size_t first = static_cast<size_t>(y) * width + static_cast<size_t>(x);
      const int columns = std::min(4, tile.x1 - x), rows = std::min(4, tile.y1 - y);
      for (int i = 0; i < kLanes; ++i) {
        if (laneX(i) >= columns || laneY(i) >= rows) continue;
        const size_t at = first + static_cast<size_t>(laneY(i)) * width + static_cast<size_t>(laneX(i));
        image.color[at] = image.depth[at] != Image::kMiss ? color[i] : image.missColor;
      }
    }
  }
}

HWY_ATTR void relightTile(const FrameData& frame, const Tile& tile, const TileVisibility& visibility) {
  if (frame.caughtOcclusion) return showOcclusion(tile, visibility, *frame.caughtOcclusion, *frame.image);
  Work work;
  eachKeptPacket(frame, *frame.moving->hits, tile, work,
                 [&]() HWY_ATTR { relightWork(frame, tile, visibility, work); });
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
