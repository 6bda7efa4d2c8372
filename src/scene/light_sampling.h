// How the samples of light become a snapshot's picture. Plain data.
#pragma once
#include <cstdint>

namespace gluray::scene {

struct LightSampling {
  enum Mode : uint8_t { full, moving };
  Mode mode = full;   // moving: one of a row of pictures that differ, shown for a moment
  uint32_t pass = 0;  // of a refinement: takes the samples that follow those of the passes before
  bool operator==(const LightSampling&) const = default;
};

}  // namespace gluray::scene
