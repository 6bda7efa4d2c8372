// Text images.
#include "intercept/hud/text_image.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::intercept {
namespace {

const TextStyle kPlain{.scale = 1, .ink = 0xFFFFFFFF, .ground = 0xFF000000};

/// The image's rows from the top, with '#' for ink.
std::vector<std::string> rows(const Image& image) {
  std::vector<std::string> all;
  for (int y = image.height - 1; y >= 0; --y) {
    std::string row;
    for (int x = 0; x < image.width; ++x)
      row += image.color[static_cast<size_t>(y * image.width + x)] == kPlain.ink ? '#' : '.';
    all.push_back(row);
  }
  return all;
}

TEST(TextImage, ShowsLettersUpright) {
  Image image;
  drawText({"L7"}, kPlain, image);
  const std::vector<std::string> expected{"..................", "..................", "..................",
                                          "...#.....#####....", "...#.........#....", "...#........#.....",
                                          "...#.......#......", "...#......#.......", "...#......#.......",
                                          "...#####..#.......", "..................", "..................",
                                          ".................."};
  EXPECT_EQ(rows(image), expected);
  EXPECT_TRUE(std::all_of(image.depth.begin(), image.depth.end(), [](float d) { return d == 0; }));
}

TEST(TextImage, SmallLettersAreCapitalsAndStrangersBlanks) {
  Image small, capital, strange, blank;
  drawText({"ab"}, kPlain, small), drawText({"AB"}, kPlain, capital);
  drawText({"\x01\xff"}, kPlain, strange), drawText({"  "}, kPlain, blank);
  EXPECT_EQ(small.color, capital.color);
  EXPECT_EQ(strange.color, blank.color);
  EXPECT_NE(small.color, blank.color);
}

TEST(TextImage, IsAsWideAsItsLongestLineAndLargerByTheScale) {
  Image one, three;
  drawText({"1", "4444"}, kPlain, one);
  drawText({"1", "4444"}, {.scale = 3}, three);
  EXPECT_EQ(one.width, 6 + 4 * 6);
  EXPECT_EQ(three.width, 3 * one.width);
  EXPECT_EQ(three.height, 3 * one.height);
}

}  // namespace
}  // namespace gluray::intercept
