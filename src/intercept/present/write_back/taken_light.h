// The light that surfaces take from the pixels of a framebuffer, as opacities of black. Any thread.
#pragma once
#include "frame/pixels/hit_bands.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::present {

struct TakenLight {
  int x = 0, y = 0, width = 0, height = 0;  // of the rectangle, window pixels
  int rowBytes = 0;                         // of a row; a multiple of 4
  std::vector<uint8_t> opacity;             // one byte a pixel, bottom row first; 0: the pixel stays
  std::vector<frame::Band> bands;           // outside of these all pixels stay

  /// Gives it this size, with memory for its opacities; these and the bands are undefined. Throws
  /// std::bad_alloc.
  void resize(int newWidth, int newHeight) {
    width = newWidth, height = newHeight, rowBytes = (newWidth + 3) / 4 * 4;
    opacity.resize(static_cast<size_t>(rowBytes) * static_cast<size_t>(height));
  }
  const uint8_t* at(int column, int row) const {
    return opacity.data() + static_cast<size_t>(row) * static_cast<size_t>(rowBytes) +
           static_cast<size_t>(column);
  }
};

}  // namespace gluray::present
