// A packet from rays to pixels, and the tile loop. Part of kernels.cpp (compiled once for each instruction
// set).
#if defined(GLURAY_RENDER_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PACKET_INL_H_
#undef GLURAY_RENDER_PACKET_INL_H_
#else
#define GLURAY_RENDER_PACKET_INL_H_
#endif

#include "render/averages.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Calls store(place in the image, lane) for the packet's pixels within the tile.
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
    for (size_t c = 0; c < 4; ++c) image.wide[4 * at + c] = work.wide[c][i];
    if (!image.through.empty()) image.through[at] = work.through[i];
  });
}

HWY_ATTR inline void storePixels(const Work& work, const Tile& tile, Image& image) {
  if (image.content != Image::Content::color) return storeWide(work, tile, image);
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

// Last stage: colour and depth into the image.
HWY_ATTR inline void finishWork(const FrameData& frame, const Tile& tile, Work& work, Averages* averages) {
  const uint32_t missColor = averages ? 0 : frame.image->missColor;
  for (int i = 0; i < kLanes; ++i) {
    work.color[i] = missColor;
    work.depth[i] = Image::kMiss;
    work.through[i] = 1;
    for (Row& row : work.wide) row[i] = 0;
  }
  work.edged = 0;
  if (frame.widestEdge > 0) {
    alignas(64) int32_t valid[kLanes];
    std::copy_n(work.valid, kLanes, valid);
    pickEdged(frame, valid, work);
  }
  if (work.hits && frame.snapshot->layers)
    shadeLayers(frame, *frame.snapshot->layers, work);
  else if (work.hits)
    shadeNearest(frame, work);
  if (averages)
    averages->add(frame, tile, work);
  else
    storePixels(work, tile, *frame.image);
}

// The packet of the 4x4 pixels from image pixel (x, y) on.
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
}

/// Three packets are under way at a time, a stage apart, so that the memory each stage needs arrives while
/// others compute.
HWY_ATTR inline void traceSamples(const FrameData& frame, const Tile& tile, Averages* averages) {
  Work works[3];
  for (Work& work : works) initPacket(work.packet);
  int count = 0;
  const bool layered = frame.snapshot->layers != nullptr;  // whose hits are found in the last stage
  const auto back = [&](int stages) HWY_ATTR -> Work& { return works[(count - stages) % 3]; };
  for (int sample = 0; sample < static_cast<int>(frame.samplePositions.size()); ++sample) {
    for (int y = tile.y0; y < tile.y1; y += 4) {
      for (int x = tile.x0; x < tile.x1; x += 4, ++count) {
        aim(frame, tile, x, y, sample, back(0));
        traceWork(frame, back(0));
        if (count > 0 && !layered) fetchVertices(frame, back(1));
        if (count > 1) finishWork(frame, tile, back(2), averages);
      }
    }
  }
  if (count > 0 && !layered) fetchVertices(frame, back(1));
  if (count > 1) finishWork(frame, tile, back(2), averages);
  if (count > 0) finishWork(frame, tile, back(1), averages);
}

HWY_ATTR void traceTile(const FrameData& frame, const Tile& tile) {
  if (!frame.averages) return traceSamples(frame, tile, nullptr);
  Averages averages;
  traceSamples(frame, tile, &averages);
  averages.store(frame, tile);
}

const char* targetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
