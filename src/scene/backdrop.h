// What shows where a view has no surface (setting `background`): which pixels may show it. Made by gl/batch,
// immutable.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::scene {

struct Backdrop {
  /// One a pixel of the snapshot's region, bottom row first; 0: the program drew something there. Empty: all
  /// pixels hold what they were cleared to.
  std::vector<uint8_t> isClear;
  bool operator==(const Backdrop&) const = default;
};

}  // namespace gluray::scene
