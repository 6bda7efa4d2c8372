// One frame of an animation while it is traced: where its factors of light go, and what of the last frame's
// can be used again. Made once a frame, read by all tracing threads, which write the films.
#pragma once
#include "render/moving/channels.h"
#include "render/moving/factor_film.h"
#include "render/moving/film_space.h"
#include "render/moving/hit_film.h"
#include "render/moving/reprojection.h"

namespace gluray::render {

/// How many rays each use of light takes in a moving frame.
struct MovingRays {
  int perPixel = 1;      // of the pixels that trace any; 0: none does, what is known is shown
  bool quarter = false;  // one pixel of four traces, in turn; and all without a history
};

struct MovingFrame {
  uint32_t index = 0;  // of the frames whose samples the films gather
  MovingRays rays;
  float mostSamples = 32;  // of a pixel's history
  FilmSpace space;
  Channels channels;
  FactorFilm* film = nullptr;
  HitFilm* hits = nullptr;
  const FactorFilm* earlier = nullptr;  // null: there is no history
  FilmSpace earlierSpace;
  Reprojection reprojection;
};

}  // namespace gluray::render
