// Pictures of windows, as stored by the program's threads, and their conversion to RGB bytes for messages.
// Any thread.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::control {

/// A frame that was shown in a window.
struct KeptPicture {
  enum class Layout {
    openGl,  // RGBA8, bottom row first
    x        // blue in the lowest byte, top row first
  };
  int width = 0, height = 0;  // pixels
  Layout layout = Layout::openGl;
  std::vector<uint32_t> pixels;  // width * height
  uint64_t frame = 0;            // its number; 0: not known
  bool next = false;             // it was shown after wantPicture(Wanted::next)
};

/// Three bytes a pixel: red, green, blue; top row first.
struct RgbPicture {
  int width = 0, height = 0;
  std::string bytes;
};

/// All of its pixels.
RgbPicture rgbOf(const KeptPicture& picture);

/// The largest picture of the same shape whose longest side has at most `longest` pixels, and that has at
/// most `mostPixels`; never larger than the picture. Each pixel is the average of those that it stands for.
RgbPicture scaledDown(const KeptPicture& picture, int longest, int64_t mostPixels);

}  // namespace gluray::control
