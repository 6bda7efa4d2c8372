// How the samples of light become a snapshot's picture. Plain data.
#pragma once
#include <cstdint>

namespace gluray::scene {

struct LightSampling {
  enum class Mode : uint8_t {
    full,    // all samples that the settings ask for
    moving,  // few samples, reused and smoothed: a frame of an animation
  };
  Mode mode = Mode::full;
  uint32_t pass = 0;  // of a refinement: takes the samples that follow those of the passes before
  bool operator==(const LightSampling&) const = default;
};

}  // namespace gluray::scene
