// Lines of text as a picture: letters of 5x7 squares, which need no font in the program's process. Any
// thread.
#pragma once
#include "base/image.h"

#include <string>
#include <string_view>
#include <vector>

namespace gluray::present {

/// How text looks. Colours are RGBA8, red in the lowest byte.
struct TextStyle {
  int scale = 2;  // pixels that a square of a letter is wide
  uint32_t ink = 0xFFFFFFFF, ground = 0xFF302018;
};

/// Whether there is a picture of the letter; capitals stand for small ones, blanks for what is missing.
bool isDrawable(char letter);

/// Makes `image` the lines on a ground one letter's margin wide, first line on top, at image.x, image.y.
/// Every pixel is a hit of depth 0.
void drawText(const std::vector<std::string>& lines, const TextStyle& style, Image& image);

}  // namespace gluray::present
