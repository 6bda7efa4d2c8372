// Where in a view a process draws surfaces, and how far away: other processes there may hide them, or be
// hidden. Any thread.
#pragma once
#include "render/tiles/tile.h"

#include <glm/glm.hpp>

#include <algorithm>

namespace gluray::render {

/// Depths are order keys: window depths, or 1 - depth where the largest depth wins, so that the smallest key
/// is the nearest.
struct DrawnPart {
  glm::ivec4 region{0};  // x, y, width, height of the image in window pixels
  glm::ivec4 tiles{0};   // of the image: columns x .. z - 1, rows y .. w - 1; empty: nothing is drawn
  float nearest = 0, farthest = 0;

  bool empty() const { return tiles.x >= tiles.z || tiles.y >= tiles.w; }
  bool contains(int column, int row) const {
    return column >= tiles.x && column < tiles.z && row >= tiles.y && row < tiles.w;
  }
  bool contains(const Tile& tile) const { return contains(tile.x0 / kTileSize, tile.y0 / kTileSize); }
  /// Whether surfaces of this part may hide some of `other`: where both have tiles.
  bool mayHide(const DrawnPart& other) const {
    return region == other.region && !empty() && !other.empty() && nearest < other.farthest &&
           std::max(tiles.x, other.tiles.x) < std::min(tiles.z, other.tiles.z) &&
           std::max(tiles.y, other.tiles.y) < std::min(tiles.w, other.tiles.w);
  }
  bool operator==(const DrawnPart&) const = default;
};

}  // namespace gluray::render
