// Writes PNG files row by row. One thread.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::launcher {

struct PngPicture {
  int width = 0, height = 0;
  bool alpha = false;                                      // otherwise opaque
  int depth = 8;                                           // bits a channel: 8, 16
  std::vector<std::pair<std::string, std::string>> texts;  // keyword, UTF-8
  /// Gives a row of premultiplied RGBA8, from the top. May throw.
  std::function<void(int y, std::vector<uint32_t>& pixels)> row;
  /// The same of 16 bits: premultiplied RGBA, 0 .. 1; what lies beyond is limited to that.
  std::function<void(int y, std::vector<float>& values)> wideRow;
};

/// Writes the picture, tagged as sRGB, beside the file and renames it. Throws std::runtime_error with one
/// line; then a file of that name stays as it was.
void writePng(const std::string& file, const PngPicture& picture);

}  // namespace gluray::launcher
