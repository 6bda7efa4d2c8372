// Pixels that may show the background (setting `background`). Made by gl/batch, immutable.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::scene {

struct Backdrop {
  /// One per pixel of the snapshot's region, bottom row first; 0: the program has drawn into the pixel.
  /// Empty: all pixels have their clear values.
  std::vector<uint8_t> isClear;
  bool operator==(const Backdrop&) const = default;
};

}  // namespace gluray::scene
