// A traced picture: colour and depth of a rectangle of the framebuffer. Made by render/, read by
// intercept/present.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray {

/// Of surfaces that are seen through, composited: how many pixels have n >= 2 layers one behind the other.
/// Those that are not seen any more are left out, but where only some are peeled (scene::Layers::peels). The
/// last number stands for all that are larger.
struct LayerCounts {
  static constexpr size_t kMost = 64;
  std::array<uint32_t, kMost> open{};    // pixels with nothing opaque behind the layers
  std::array<uint32_t, kMost> before{};  // pixels with something opaque behind them
};

/// Colour and window depth of `width` x `height` pixels (per sample where multisampled), bottom row first, as
/// OpenGL has it.
struct Image {
  static constexpr float kMiss = 2.0f;  // depth of a pixel that no ray hit
  enum class Content {
    color,  // `color`
    wide,   // `wide`: colours as floats, beyond [0, 1] if they are so
    sums,   // `wide`: sums over all fragments of colour times opacity, and of opacities; `through`
  };

  int x = 0, y = 0;             // window coordinates of the lower left pixel
  int width = 0, height = 0;    // pixels
  int samples = 1;              // planes, one per sample of a multisampled framebuffer
  std::vector<uint32_t> color;  // RGBA8, red in the lowest byte; samples planes of width*height
  std::vector<float> depth;     // window depth in [0, 1], kMiss where nothing was hit; same shape
  Content content = Content::color;
  uint32_t missColor = 0;      // what misses have in `color`; set before tracing. Of `center`'s pictures: 0
  std::vector<float> wide;     // RGBA, four a pixel, same shape; empty where the content is `color`
  std::vector<float> through;  // product of what the fragments let through, 1 - opacity; of `sums` alone
  /// Where pixels are averages over samples of their own (settings: spp), misses being 0 in all channels: the
  /// depth at their centres. `depth` is the same, or where the centre missed that of the nearest sample.
  /// Empty where every pixel is what its centre hit.
  std::vector<float> center;
  LayerCounts layers;

  /// What the planes take.
  size_t bytes() const {
    return 4 *
           (color.capacity() + depth.capacity() + wide.capacity() + through.capacity() + center.capacity());
  }

  /// Makes room for the given shape, reusing memory. Contents are undefined afterwards.
  void resize(int newWidth, int newHeight, int newSamples, Content newContent = Content::color,
              bool averages = false) {
    width = newWidth, height = newHeight, samples = newSamples, content = newContent;
    const auto count =
        static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(samples);
    color.resize(content == Content::color ? count : 0);
    depth.resize(count);
    wide.resize(content == Content::color ? 0 : count * 4);
    through.resize(content == Content::sums ? count : 0);
    center.resize(averages ? count : 0);
  }
};

}  // namespace gluray
