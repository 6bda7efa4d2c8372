// Traces frames of animations: first visibility, which are then filtered, and finally the colours
// of hits. Called by traceImage().
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/moving/light_history.h"
#include "render/moving/moving_tile_source.h"

namespace gluray::render {

/// Whether the frame is one of an animation (scene::LightSampling::Mode::moving) whose pixels have one
/// nearest hit each, so that visibility can be filtered.
bool isMoving(const FrameData&);

class MovingTileSource;

/// Traces all visibility, filters them, and then colours the hits. `kept`: history of earlier frames; null:
/// none. `source`: hands out the tiles; null: this process traces all of them. Returns false, with nothing
/// traced, if the settings use no visibility or memory is short.
bool traceMoving(FrameData&, LightHistories* kept, const MovingRays&, MovingTileSource* source);

}  // namespace gluray::render
