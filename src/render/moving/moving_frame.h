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
  PixelSpace space;
  Channels channels;
  VisibilityBuffer* visibility = nullptr;
  HitBuffer* hits = nullptr;
  const VisibilityBuffer* earlier = nullptr;  // null: no history
  PixelSpace earlierSpace;
  Reprojection reprojection;
};

}  // namespace gluray::render
