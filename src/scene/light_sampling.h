// How the samples of light become a snapshot's picture. Plain data.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

struct LightSampling {
  enum class Mode : uint8_t {
    full,    // all samples that the settings ask for
    moving,  // few samples, reused and smoothed: a frame of an animation
    // No light; colours tell a filter what a pixel shows (render/effects/guides.h):
    reflectance,  // what multiplies light there
    geometry,     // where it is, and its normal
    // or somebody who picks a pixel:
    surfaces,  // which instance it shows, and its normal
    points,    // which instance it shows, and where
  };
  Mode mode = Mode::full;
  uint32_t pass = 0;  // of a refinement: takes the samples that follow those of the passes before
  /// Of a pass: the tiles that it traces, a byte each, row by row, kTile pixels wide and high; the image
  /// keeps what it has elsewhere. Null: all.
  std::shared_ptr<const std::vector<uint8_t>> tiles;
  static constexpr int kTile = 32;
  bool operator==(const LightSampling&) const = default;
};

}  // namespace gluray::scene
