// Source of tiles for moving frames that several processes trace together. Implemented in cluster/.
#pragma once
#include "render/moving/visibility_buffer.h"
#include "render/tiles/tile_source.h"

#include <cstdint>

namespace gluray::render {

/// Hands out the tiles of a moving frame (scene::LightSampling::Mode::moving). A process first collects each
/// of its tiles: hits, and surfaces and visibility on the visibility buffer. Once the visibility buffer is
/// complete, the process colours the tiles that it has collected. Frames that cannot be traced in this way
/// use only the functions of TileSource.
class MovingTileSource : public TileSource {
 public:
  /// Number of the frame in its view, equal in all processes that share the visibility buffer. `own`: this
  /// process's own count.
  virtual uint32_t index(uint32_t own) const noexcept = 0;
  /// Reports that a tile from nextTile() has been collected. All tracing threads.
  virtual void collected(const VisibilityBuffer& buffer, int tile, double seconds) noexcept = 0;
  /// Waits until all tiles have been collected, and fills in the tiles of other processes. Returns false if
  /// the frame is abandoned. One thread, once nextTile() has no more tiles.
  virtual bool complete(VisibilityBuffer& buffer) noexcept = 0;
  /// Returns the next tile to colour, which this process has collected; negative: none left. The caller then
  /// calls done(). All tracing threads.
  virtual int nextToColor() noexcept = 0;
};

}  // namespace gluray::render
