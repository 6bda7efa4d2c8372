// Traces frames of animations: factors of light first, then the colours of the hits, once these are smooth.
// Called by traceImage().
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/moving/film_source.h"
#include "render/moving/light_history.h"

namespace gluray::render {

/// Whether the frame is one of an animation (scene::LightSampling::Mode::moving) whose pixels have one
/// nearest hit each, so that factors can be smoothed.
bool isMoving(const FrameData&);

class FilmSource;

/// Traces all factors, smooths them, and then colours the hits. `kept`: what earlier frames left; null:
/// nothing. `source`: hands out the tiles; null: this process traces all of them. False, with nothing traced,
/// if the settings ask for no factors or there is no memory.
bool traceMoving(FrameData&, LightHistories* kept, const MovingRays&, FilmSource* source);

}  // namespace gluray::render
