// The pixels of a tile whose surfaces other processes hide. Plain data.
#pragma once
#include "render/tiles/tile.h"

#include <array>
#include <cstdint>

namespace gluray::render {

struct HiddenPixels {
  std::array<uint32_t, kTileSize> rows{};  // bit x of rows[y]: the pixel at (x, y) from the lower left corner
  static_assert(kTileSize == 32, "a row is a word");

  void hide(int x, int y) { rows[static_cast<size_t>(y)] |= 1u << x; }
  /// The 4x4 pixels from (x, y) on, four bits a row.
  uint32_t block(int x, int y) const {
    uint32_t bits = 0;
    for (int row = 0; row < 4; ++row) bits |= (rows[static_cast<size_t>(y + row)] >> x & 0xF) << (4 * row);
    return bits;
  }
};

}  // namespace gluray::render
