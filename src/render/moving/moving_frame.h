// State of one animation frame while it is traced: the film for its factors of light, and the reusable
// history. Made once a frame, read by all tracing threads, which write the films.
#pragma once
#include "render/moving/channels.h"
#include "render/moving/factor_film.h"
#include "render/moving/film_space.h"
#include "render/moving/hit_film.h"
#include "render/moving/reprojection.h"

namespace gluray::render {

/// Ray counts of a moving frame for each use of light.
struct MovingRays {
  int perPixel = 1;      // for pixels that trace rays; 0: the history is shown without new rays
  bool quarter = false;  // one pixel of four traces rays, in turn; without history all pixels do
};

struct MovingFrame {
  uint32_t index = 0;  // of the frame among those accumulated on the films
  MovingRays rays;
  float mostSamples = 32;  // of a pixel's history
  FilmSpace space;
  Channels channels;
  FactorFilm* film = nullptr;
  HitFilm* hits = nullptr;
  const FactorFilm* earlier = nullptr;  // null: no history
  FilmSpace earlierSpace;
  Reprojection reprojection;
};

}  // namespace gluray::render
