// Images of windows, as stored by the program's threads, and their conversion to RGB bytes for messages.
// Any thread.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::control {

/// A frame that was shown in a window.
struct KeptImage {
  enum class Layout {
    openGl,  // RGBA8, bottom row first
    x        // blue in the lowest byte, top row first
  };
  int width = 0, height = 0;  // pixels
  Layout layout = Layout::openGl;
  std::vector<uint32_t> pixels;  // width * height
  uint64_t frame = 0;            // number of the frame; 0: unknown
  bool next = false;             // it was shown after wantImage(Wanted::next)
};

/// Three bytes per pixel: red, green, blue; top row first.
struct RgbImage {
  int width = 0, height = 0;
  std::string bytes;
};

/// The whole image as RGB bytes.
RgbImage rgbOf(const KeptImage& image);

/// The image, scaled down to the largest size of the same shape with a longest side of at most `longest`
/// pixels and at most `mostPixels` pixels; never enlarged. Each pixel is the average of those that it
/// replaces.
RgbImage scaledDown(const KeptImage& image, int longest, int64_t mostPixels);

}  // namespace gluray::control
