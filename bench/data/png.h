// PNG files in and out.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::bench {

/// RGB8, top row first, width * height * 3 bytes.
struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;
};

/// Picture of RGBA8 pixels, bottom row first as OpenGL gives them; alpha is dropped.
Picture pictureFromGl(int width, int height, const std::vector<uint8_t>& rgba);

/// Both throw std::runtime_error with one clear line where the file cannot be read or written.
Picture readPng(const std::string& path);
void writePng(const Picture& picture, const std::string& path);

/// The pictures from left to right, `gap` white columns between them, top edges aligned.
Picture sideBySide(const std::vector<Picture>& pictures, int gap);

}  // namespace gluray::bench
