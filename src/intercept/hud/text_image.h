// Renders lines of text into an image, with letters of 5x7 squares, so that no font library is needed. Any
// thread.
#pragma once
#include "base/image.h"

#include <string>
#include <string_view>
#include <vector>

namespace gluray::intercept {

/// Colours are RGBA8, red in the lowest byte.
struct TextStyle {
  int scale = 2;  // pixels per square of a letter
  uint32_t ink = 0xFFFFFFFF, ground = 0xFF302018;
};

/// Whether the letter has an image. Lower-case letters are drawn as capitals, missing letters as blanks.
bool isDrawable(char letter);

/// Draws the lines into `image`, first line on top, with a margin, at (image.x, image.y). Every pixel is a
/// hit with depth 0.
void drawText(const std::vector<std::string>& lines, const TextStyle& style, Image& image);

}  // namespace gluray::intercept
