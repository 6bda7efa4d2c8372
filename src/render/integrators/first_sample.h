// Which samples of a pixel's sequence a hit takes. Any thread.
#pragma once
#include "render/frame_data.h"
#include "render/sampling/sobol.h"

#include <algorithm>

namespace gluray::render {

/// Index of the first of the samples that sample `sample` of a pixel takes in this pass, with `count` for
/// each.
inline uint32_t firstSample(const FrameData& frame, int sample, int count) {
  const auto perPixel = static_cast<uint32_t>(std::max<size_t>(frame.samplePositions.size(), 1));
  const uint32_t pass = frame.snapshot->lightSampling.pass;
  return (pass * perPixel + static_cast<uint32_t>(sample)) * static_cast<uint32_t>(count);
}

/// The number of samples at a point, if settings ask for `count`.
inline int samplesOf(const FrameData&, int count) { return count; }

/// Seeds for hits at window positions.
inline PixelSeeds seedsOf(const FrameData&, const float* x, const float* y) { return {x, y}; }

}  // namespace gluray::render
