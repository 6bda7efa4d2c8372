// A part of an image that one thread traces at a time. Any thread.
#pragma once

namespace gluray::render {

constexpr int kTileSize = 32;  // pixels, a multiple of 4

/// A rectangle of the image, at most kTileSize wide and high, in pixels from its lower left corner.
struct Tile {
  int x0, y0, x1, y1;  // exclusive ends
};

}  // namespace gluray::render
