// The parts of a Context that the classes of gl/layers use. GL thread.
#pragma once
#include "gl/clock/frame_clock.h"
#include "gl/counts/draw_counts.h"
#include "gl/framebuffers/cleared_framebuffers.h"
#include "gl/pending/batch_flush.h"
#include "gl/pending/pending_batch.h"

namespace gluray::gl {

struct LayerParts {
  ShadowState& shadow;
  Failsafe& failsafe;
  FrameClock& clock;
  DrawCounts& counts;
  ClearedFramebuffers& cleared;
  PendingBatch& pending;
  BatchFlush& flush;
};

}  // namespace gluray::gl
