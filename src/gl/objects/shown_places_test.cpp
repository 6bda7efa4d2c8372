#include "gl/commands/shown_places.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using Points = std::vector<glm::vec4>;
constexpr glm::ivec4 kShownViewport{0, 0, 200, 100};

TEST(ShownPlacesTest, CornersGiveARectangleOfTheWindow) {
  const Points strip{{-1, -1, 0, 1}, {0, -1, 0, 1}, {-1, 1, 0, 1}, {0, 1, 0, 1}};
  EXPECT_EQ(rectangleOf(strip, kShownViewport), glm::ivec4(0, 0, 100, 100));
  const Points triangles{{0, 0, 0, 2}, {1, 0, 0, 2}, {1, 1, 0, 2}, {1, 1, 0, 2}, {0, 1, 0, 2}, {0, 0, 0, 2}};
  EXPECT_EQ(rectangleOf(triangles, kShownViewport), glm::ivec4(100, 50, 50, 25)) << "divided by w";
  EXPECT_EQ(rectangleOf(strip, {10, 20, 200, 100}), glm::ivec4(10, 20, 100, 100));
}

TEST(ShownPlacesTest, OtherShapesGiveNone) {
  const glm::ivec4 none(0);
  EXPECT_EQ(rectangleOf({{-1, -1, 0, 1}, {0, -1, 0, 1}, {-1, 1, 0, 1}, {0.5f, 1, 0, 1}}, kShownViewport),
            none);
  EXPECT_EQ(rectangleOf({{-1, -1, 0, 1}, {0, -1, 0, 1}, {0, 1, 0, 1}, {0, 1, 0, 1}}, kShownViewport), none)
      << "three corners";
  EXPECT_EQ(rectangleOf({{-1, -1, 0, 0}, {0, -1, 0, 1}, {-1, 1, 0, 1}, {0, 1, 0, 1}}, kShownViewport), none);
  EXPECT_EQ(rectangleOf(Points(4, glm::vec4(0, 0, 0, 1)), kShownViewport), none);
  EXPECT_EQ(rectangleOf({}, kShownViewport), none);
}

}  // namespace
}  // namespace gluray::gl
