#include "scene/box_corner.h"

#include <gtest/gtest.h>

namespace gluray::scene {
namespace {

TEST(BoxCorner, BitsChooseTheUpperSide) {
  const glm::vec3 lower(1, 2, 3), upper(10, 20, 30);
  EXPECT_EQ(boxCorner(lower, upper, 0), lower);
  EXPECT_EQ(boxCorner(lower, upper, 1), glm::vec3(10, 2, 3));
  EXPECT_EQ(boxCorner(lower, upper, 2), glm::vec3(1, 20, 3));
  EXPECT_EQ(boxCorner(lower, upper, 4), glm::vec3(1, 2, 30));
  EXPECT_EQ(boxCorner(lower, upper, 7), upper);
}

}  // namespace
}  // namespace gluray::scene
