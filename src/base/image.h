// A traced picture: colour and depth of a rectangle of the framebuffer. Made by render/, read by
// intercept/present.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray {

/// Colour and window depth of `width` x `height` pixels (per sample where multisampled), bottom row first, as
/// OpenGL has it.
struct Image {
  static constexpr float kMiss = 2.0f;  // depth of a pixel that no ray hit

  int x = 0, y = 0;             // window coordinates of the lower left pixel
  int width = 0, height = 0;    // pixels
  int samples = 1;              // planes, one per sample of a multisampled framebuffer
  std::vector<uint32_t> color;  // RGBA8, red in the lowest byte; samples planes of width*height
  std::vector<float> depth;     // window depth in [0, 1], kMiss where nothing was hit; same shape

  /// Makes room for the given shape, reusing memory. Contents are undefined afterwards.
  void resize(int newWidth, int newHeight, int newSamples) {
    width = newWidth, height = newHeight, samples = newSamples;
    const auto count =
        static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(samples);
    color.resize(count);
    depth.resize(count);
  }
};

}  // namespace gluray
