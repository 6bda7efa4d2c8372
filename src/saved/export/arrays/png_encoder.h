// PNG files of textures are made by whoever exports, so that the engine needs no library for them. Any
// thread.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace gluray::saved {

/// Eight bits a channel: red, green, blue and, if `alpha`, straight alpha; the file's first row first.
struct PngPixels {
  int width = 0, height = 0;
  bool alpha = false;
  std::vector<uint8_t> bytes;
};

/// The bytes of a PNG file. Throws std::runtime_error with one line.
using PngEncoder = std::function<std::string(const PngPixels&)>;

}  // namespace gluray::saved
