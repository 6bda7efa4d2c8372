// PNG files in and out.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::bench {

/// RGB8, top row first, width * height * 3 bytes.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;
};

/// Image of RGBA8 pixels, bottom row first as OpenGL gives them; alpha is dropped.
RgbImage imageFromGl(int width, int height, const std::vector<uint8_t>& rgba);

/// Both throw std::runtime_error with one clear line where the file cannot be read or written.
RgbImage readPng(const std::string& path);
void writePng(const RgbImage& image, const std::string& path);

/// The images from left to right, `gap` white columns between them, top edges aligned.
RgbImage sideBySide(const std::vector<RgbImage>& images, int gap);

}  // namespace gluray::bench
