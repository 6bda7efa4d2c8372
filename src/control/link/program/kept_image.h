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
  uint64_t frame = 0;            // its number; 0: not known
  bool next = false;             // it was shown after wantImage(Wanted::next)
};

/// Three bytes a pixel: red, green, blue; top row first.
struct RgbImage {
  int width = 0, height = 0;
  std::string bytes;
};

/// All of its pixels.
RgbImage rgbOf(const KeptImage& image);

/// The largest image of the same shape whose longest side has at most `longest` pixels, and that has at
/// most `mostPixels`; never larger than the image. Each pixel is the average of those that it stands for.
RgbImage scaledDown(const KeptImage& image, int longest, int64_t mostPixels);

}  // namespace gluray::control
