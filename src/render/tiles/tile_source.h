// Where the tiles of an image come from that several processes trace together. Implemented by dist/.
#pragma once
#include "base/image.h"

namespace gluray::render {

/// Hands out the tiles of an image that several processes trace together. All tracing threads.
class TileSource {
 public:
  virtual ~TileSource() = default;
  /// Called once, before all else: the image has its shape and keeps its place; its pixels are undefined.
  virtual void begin(const Image& image) noexcept = 0;
  /// The next tile to trace, an index of Tiles; negative: there are no more. May wait.
  virtual int nextTile() noexcept = 0;
  /// The tile's pixels are in the image. `seenThrough`: averages cannot be composited over the framebuffer,
  /// as far as this process has seen: the image must be traced anew without them.
  virtual void done(int tile, double seconds, bool seenThrough) noexcept = 0;
};

}  // namespace gluray::render
