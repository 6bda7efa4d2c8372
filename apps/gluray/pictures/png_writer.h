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
  std::vector<std::pair<std::string, std::string>> texts;  // keyword, UTF-8
  /// Gives a row of premultiplied RGBA8, from the top. May throw.
  std::function<void(int y, std::vector<uint32_t>& pixels)> row;
};

/// Writes the picture, tagged as sRGB, beside the file and renames it. Throws std::runtime_error with one
/// line; then a file of that name stays as it was.
void writePng(const std::string& file, const PngPicture& picture);

}  // namespace gluray::launcher
