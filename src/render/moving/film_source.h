// Where the tiles of a moving frame come from that several processes trace together. Implemented by dist/.
#pragma once
#include "render/moving/factor_film.h"
#include "render/tiles/tile_source.h"

#include <cstdint>

namespace gluray::render {

/// Hands out the tiles of a moving frame (scene::LightSampling::Mode::moving) that several processes trace
/// together. Each tile is collected first: its hits, and its surfaces and factors on the film. Once the film
/// is whole, the process that collected a tile colours it. Frames that cannot be traced like that take the
/// functions of a TileSource alone.
class FilmSource : public TileSource {
 public:
  /// The frame's number among those of its view; `own`: as this process counts them. Processes that share one
  /// film have the same number.
  virtual uint32_t index(uint32_t own) const noexcept = 0;
  /// The tile, from nextTile(), has been collected. All tracing threads.
  virtual void collected(const FactorFilm& film, int tile, double seconds) noexcept = 0;
  /// Waits until all tiles have been collected, and fills in what other processes have. False: the frame is
  /// given up. One thread, once nextTile() has no more tiles.
  virtual bool complete(FactorFilm& film) noexcept = 0;
  /// The next tile to colour, one that this process has collected; negative: there are no more. done() is
  /// called afterwards. All tracing threads.
  virtual int nextToColor() noexcept = 0;
};

}  // namespace gluray::render
