// Source of tiles for images that several processes trace together. Implemented in cluster/.
#pragma once
#include "base/image.h"

namespace gluray::render {

/// Hands out the tiles of an image that several processes trace together. All tracing threads.
class TileSource {
 public:
  virtual ~TileSource() = default;
  /// Called once, before all other functions: the image has its final size and address; its pixels are
  /// undefined.
  virtual void begin(const Image& image) noexcept = 0;
  /// Returns the next tile to trace, an index of Tiles; negative: none left. May wait.
  virtual int nextTile() noexcept = 0;
  /// Reports that the tile's pixels are in the image. `seenThrough`: this process found that averages cannot
  /// be composited over the framebuffer, so the image must be traced again without them.
  virtual void done(int tile, double seconds, bool seenThrough) noexcept = 0;
};

}  // namespace gluray::render
