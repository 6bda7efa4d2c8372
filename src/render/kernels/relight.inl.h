// The second pass over a moving frame: colours the hits that the first one kept, whose visibility is smooth
// by now. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_RELIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RELIGHT_INL_H_
#undef GLURAY_RENDER_RELIGHT_INL_H_
#else
#define GLURAY_RENDER_RELIGHT_INL_H_
#endif

#include "render/moving/filter.h"
#include "render/packets/kept_hits.inl.h"
#include "render/packets/pixels.inl.h"
#include "render/packets/trace.inl.h"
#include "render/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Last stage: colours the hits and writes the pixels.
HWY_ATTR inline void relightWork(const FrameData& frame, const Tile& tile, const TileVisibility& visibility,
                                 Work& work) {
  clearPixels(frame.image->missColor, work);
  if (work.hits) {
    work.edged = frame.moving->hits->lanes[frame.moving->hits->at(work.imageX, work.imageY)].edged;
    work.visibility = &visibility.at(work.imageX - tile.x0, work.imageY - tile.y0);
    const bool wide = frame.image->has(Plane::wideColor);
    shadeHits(frame, work.hits, false, work,
              [&](uint32_t lanes, const LitRows& rows, const float* depth)
                  HWY_ATTR { mergeShown(lanes, rows, depth, wide, work); });
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

/// Pipelined as the first pass is, but no rays are traced meanwhile: the stages are several packets apart,
/// because memory takes longer than colours.
HWY_ATTR void relightTile(const FrameData& frame, const Tile& tile, const TileVisibility& visibility) {
  if (frame.caughtOcclusion) return showOcclusion(tile, visibility, *frame.caughtOcclusion, *frame.image);
  constexpr int kApart = 2;  // packets
  const HitBuffer& buffer = *frame.moving->hits;
  const int columns = (tile.x1 - tile.x0 + 3) / 4, count = columns * ((tile.y1 - tile.y0 + 3) / 4);
  const auto xOf = [&](int packet) { return tile.x0 + packet % columns * 4; };
  const auto yOf = [&](int packet) { return tile.y0 + packet / columns * 4; };
  struct Corners {
    alignas(64) uint32_t vertex[3][kLanes];
  };
  Corners fetched[kApart];  // of the packets that are coloured next
  Work work;
  initPacket(work.packet);
  const auto color = [&](int packet) HWY_ATTR {
    aim(frame, tile, xOf(packet), yOf(packet), 0, work);
    recall(buffer, work);
    std::memcpy(work.vertex, fetched[packet % kApart].vertex, sizeof work.vertex);
    relightWork(frame, tile, visibility, work);
  };
  for (int first = 0; first < count + 2 * kApart; ++first) {
    if (first >= 2 * kApart) color(first - 2 * kApart);
    if (const int second = first - kApart; second >= 0 && second < count) {
      const size_t at = buffer.at(xOf(second), yOf(second));
      fetchVertices(frame, buffer.lanes[at].shown, buffer.hits[at].instance, buffer.hits[at].primitive,
                    fetched[second % kApart].vertex);
    }
    if (first < count) {
      const size_t at = buffer.at(xOf(first), yOf(first));
      prefetchTriangles(frame, buffer.lanes[at].shown, buffer.hits[at].instance, buffer.hits[at].primitive);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
