// State of one animation frame while it is traced: the visibility buffer, and the reusable
// history. Made once a frame, read by all tracing threads, which write the buffers.
#pragma once
#include "render/moving/channels.h"
#include "render/moving/hit_buffer.h"
#include "render/moving/pixel_space.h"
#include "render/moving/reprojection.h"
#include "render/moving/visibility_buffer.h"

namespace gluray::render {

/// Ray counts of a moving frame for each use of light.
struct MovingRays {
  int perPixel = 1;      // for pixels that trace rays; 0: the history is shown without new rays
  bool quarter = false;  // one pixel of four traces rays, in turn; without history all pixels do
};

struct MovingFrame {
  uint32_t index = 0;  // of the frame among those accumulated on the buffers
  MovingRays rays;
  float mostSamples = 32;  // of a pixel's history
  // Of its history of shadows, which count less where lights have moved; 0: shadows have no history, and all
  // pixels trace rays.
  float mostLightSamples = VisibilityBuffer::kMaxSamples;
  PixelSpace space;
  Channels channels;
  VisibilityBuffer* visibility = nullptr;
  HitBuffer* hits = nullptr;
  const VisibilityBuffer* earlier = nullptr;  // null: no history
  PixelSpace earlierSpace;
  Reprojection reprojection;

  /// Whether a channel is the visibility of a light.
  bool isOfLight(int channel) const { return channel > 0 || !channels.used.occlusion; }
  /// Most samples of a channel's history.
  float mostSamplesOf(int channel) const {
    return isOfLight(channel) ? mostLightSamples : static_cast<float>(VisibilityBuffer::kMaxSamples);
  }
  /// Most samples of a channel, with those of this frame.
  float mostKnownOf(int channel) const { return mostSamplesOf(channel) + static_cast<float>(rays.perPixel); }
};

}  // namespace gluray::render
