// Light sampling of a snapshot's image. Plain data.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

struct LightSampling {
  enum class Mode : uint8_t {
    full,    // all samples of the settings
    moving,  // few samples with temporal reuse and filtering: a frame of an animation
    // No light; colours are auxiliary features for denoising (render/effects/feature_integrators.h):
    reflectance,  // reflectance of the surface
    geometry,     // position and normal of the surface
    // or for picking:
    surfaces,  // instance and normal
    points,    // instance and point
    // for denoising, of paths:
    noiseless,  // light that is equal in all passes: of lights without size, and emitted
  };
  Mode mode = Mode::full;
  uint32_t pass = 0;  // of a refinement: uses the samples after those of earlier passes
  /// Tiles that the pass traces, one byte each, row by row, kTile pixels wide and high; other tiles of the
  /// image stay unchanged. Null: all.
  std::shared_ptr<const std::vector<uint8_t>> tiles;
  static constexpr int kTile = 32;
  /// Of a moving frame: uses no visibility of earlier frames, whose scene was another one.
  bool anew = false;
  /// Of a moving frame without layers and lens: pixels have one sample, whatever the settings, because the
  /// frame is refined in its window when it rests.
  bool aliased = false;
  bool operator==(const LightSampling&) const = default;
};

}  // namespace gluray::scene
