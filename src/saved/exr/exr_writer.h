// Writes OpenEXR files row by row. Any thread; one file at a time.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::saved {

struct ExrChannel {
  std::string name;   // with its layer: "albedo.R"
  bool half = false;  // 16 bits, not 32
};

/// One part of scan lines. Its primaries are those of sRGB (Rec. 709).
struct ExrPicture {
  int width = 0, height = 0;
  std::vector<ExrChannel> channels;
  std::vector<std::pair<std::string, std::string>> texts;  // attributes of the header
  /// Gives a row, from the top: for each pixel the values of all channels, in their order. May throw.
  std::function<void(int y, float* values)> row;
};

/// Whether this GLuRay was built with OpenEXR.
bool canWriteExr();
/// Writes the picture beside the file and renames it. Throws std::runtime_error with one line; then a file of
/// that name stays as it was.
void writeExr(const std::string& file, const ExrPicture& picture);

}  // namespace gluray::saved
