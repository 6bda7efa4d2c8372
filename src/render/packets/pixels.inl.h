// The pixels of a packet: positions, initial values, and storing into the image. Part of kernels.cpp
// (compiled once for each instruction set).
#if defined(GLURAY_RENDER_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PIXELS_INL_H_
#undef GLURAY_RENDER_PIXELS_INL_H_
#else
#define GLURAY_RENDER_PIXELS_INL_H_
#endif

#include "render/lights/lamps.h"
#include "render/packets/hits.inl.h"
#include "render/sampling/warp.inl.h"
#include "render/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Chooses the points of the lens that the packet's rays leave.
HWY_ATTR HWY_NOINLINE inline void aimThroughLens(const FrameData& frame, Work& work) {
  const PixelSeeds seeds(work.x, work.y);
  const auto perPixel = static_cast<uint32_t>(frame.samplePositions.size()) - 1;
  const uint32_t index =
      frame.snapshot->lightSampling.pass * perPixel + static_cast<uint32_t>(work.sample) - 1;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Sample2 at = unitDisc(sample2(seeds, i, index, Dimensions::lens));
    store(at.x, work.lensPoints.x + i), store(at.y, work.lensPoints.y + i);
  }
}

// Sets up the packet of the 4x4 pixels from image pixel (x, y) on.
HWY_ATTR inline void aim(const FrameData& frame, const Tile& tile, int x, int y, int sample, Work& work) {
  const scene::Region& region = frame.snapshot->region;
  const glm::dvec2 offset = frame.samplePositions[static_cast<size_t>(sample)];
  const auto windowX = static_cast<float>(region.x + x + offset.x);
  const auto windowY = static_cast<float>(region.y + y + offset.y);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    store(hn::Add(load(kLaneOffsets.x + i), splat(windowX)), work.x + i);
    store(hn::Add(load(kLaneOffsets.y + i), splat(windowY)), work.y + i);
  }
  const bool whole = x + 4 <= tile.x1 && y + 4 <= tile.y1;
  for (int i = 0; i < kLanes; ++i) work.valid[i] = -1;
  for (int i = 0; i < kLanes && !whole; ++i) {
    if (x + laneX(i) >= tile.x1 || y + laneY(i) >= tile.y1) work.valid[i] = 0;
  }
  work.imageX = x;
  work.imageY = y;
  work.sample = sample;
  work.lens = frame.lens && sample > 0 ? frame.lens.get() : nullptr;
  if (work.lens) aimThroughLens(frame, work);
}

HWY_ATTR inline Centers centersOf(const Work& work) {
  Centers centers;
  for (int i = 0; i < kLanes; ++i) {
    centers.x[i] = std::floor(work.x[i]) + 0.5f;
    centers.y[i] = std::floor(work.y[i]) + 0.5f;
  }
  return centers;
}

// Sets all pixels to misses.
HWY_ATTR inline void clearPixels(uint32_t missColor, Work& work) {
  for (int i = 0; i < kLanes; ++i) {
    work.color[i] = missColor;
    work.depth[i] = Image::kMiss;
    work.through[i] = 1;
    for (Row& row : work.wide) row[i] = 0;
  }
  work.edged = 0;
}

/// Shows lights that can be seen in front of the packet's surfaces. Not inlined, as lightHits().
HWY_ATTR HWY_NOINLINE inline void showLamps(const FrameData& frame, Work& work) {
  LitRows rows;
  alignas(64) Row depth;
  std::copy_n(work.depth, kLanes, depth);
  const uint32_t lanes = frame.lamps->show(work.x, work.y, work.lens ? &work.packet : nullptr, depth, rows);
  if (!lanes) return;
  if (frame.tone) frame.tone->apply(rows);
  merge(lanes, rows, depth, !frame.bytes, work);
}

/// Calls store(pixel index, lane) for the packet's pixels within the tile.
template <class Store>
HWY_INLINE void eachPixel(const Work& work, const Tile& tile, const Image& image, Store&& store) {
  for (int i = 0; i < kLanes; ++i) {
    const int x = work.imageX + laneX(i), y = work.imageY + laneY(i);
    if (x >= tile.x1 || y >= tile.y1) continue;
    const size_t row =
        static_cast<size_t>(work.sample) * static_cast<size_t>(image.height) + static_cast<size_t>(y);
    store(row * static_cast<size_t>(image.width) + static_cast<size_t>(x), i);
  }
}

HWY_ATTR inline void storeWide(const Work& work, const Tile& tile, Image& image) {
  eachPixel(work, tile, image, [&](size_t at, int i) HWY_ATTR {
    image.depth[at] = work.depth[i];
    for (size_t c = 0; c < 4; ++c) image.wideColor[4 * at + c] = work.wide[c][i];
    if (image.has(Plane::transmittance)) image.transmittance[at] = work.through[i];
  });
}

HWY_ATTR inline void storePixels(const Work& work, const Tile& tile, Image& image) {
  if (image.has(Plane::wideColor)) return storeWide(work, tile, image);
  if (work.imageX + 4 > tile.x1 || work.imageY + 4 > tile.y1) {
    eachPixel(work, tile, image, [&](size_t at, int i) HWY_ATTR {
      image.color[at] = work.color[i];
      image.depth[at] = work.depth[i];
    });
    return;
  }
  const auto width = static_cast<size_t>(image.width);
  const size_t plane = width * static_cast<size_t>(image.height) * static_cast<size_t>(work.sample);
  const size_t first = plane + static_cast<size_t>(work.imageY) * width + static_cast<size_t>(work.imageX);
  uint32_t* color = image.color.data() + first;
  float* depth = image.depth.data() + first;
  for (int i = 0; i < kLanes; i += 2) {
    const size_t at = static_cast<size_t>(laneY(i)) * width + static_cast<size_t>(laneX(i));
    std::memcpy(color + at, work.color + i, 8);
    std::memcpy(depth + at, work.depth + i, 8);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
