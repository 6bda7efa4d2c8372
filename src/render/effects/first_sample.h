// Indices into a pixel's sample sequence. Any thread.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/integrators/surface_points.h"
#include "render/moving/moving_frame.h"
#include "render/sampling/sobol.h"

#include <algorithm>

namespace gluray::render {

/// Index of the first light sample of pixel sample `sample` in this pass, if each pixel sample has `count`
/// light samples.
inline uint32_t firstSample(const FrameData& frame, int sample, int count) {
  if (frame.moving) return frame.moving->index * static_cast<uint32_t>(count);
  return frame.firstLightSample(sample, count);
}

/// Number of light samples at a point; the settings request `count` for a pixel. Pixels that average several
/// samples share them among these.
inline int samplesOf(const FrameData& frame, int count) {
  if (frame.moving) return std::min(count, frame.moving->rays.perPixel);
  return frame.lightSamplesEach(count);
}

/// Seeds of points: one sequence for each 4x4 block of pixels, or for each pixel that averages samples, or in
/// moving frames one for all.
inline PixelSeeds seedsOf(const FrameData& frame, const AskedPoints& asked) {
  if (!frame.moving && frame.averages) return {asked.x, asked.y};
  if (!frame.moving) return blockSeeds(asked.x, asked.y);
  const MovingFrame& moving = *frame.moving;
  // If the filter covers more than 4x4 pixels with few samples each, neighbouring blocks use different
  // points.
  const uint32_t apart = moving.rays.quarter || !moving.earlier ? 1 : 0;
  const scene::Region& region = frame.snapshot->region;
  uint32_t places[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    const auto column = static_cast<uint32_t>(static_cast<int32_t>(asked.x[i]) - region.x) >> 2,
               row = static_cast<uint32_t>(static_cast<int32_t>(asked.y[i]) - region.y) >> 2;
    places[i] = asked.place[i] | (column & apart) << 4 | (row & apart) << 5;
  }
  return interleavedSeeds(moving.rays.quarter ? moving.index / 4 : moving.index, apart ? 64 : 16, places);
}

}  // namespace gluray::render
