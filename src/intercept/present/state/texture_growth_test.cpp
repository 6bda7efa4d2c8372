#include "intercept/present/state/texture_growth.h"

#include <gtest/gtest.h>

namespace gluray::present {
namespace {

using Size = glm::ivec2;

TEST(TextureGrowth, KeepsATextureThatSuffices) {
  EXPECT_EQ(grownSize({800, 600}, {640, 480}), Size(800, 600));
  EXPECT_EQ(grownSize({800, 600}, {800, 600}), Size(800, 600));
}

TEST(TextureGrowth, CoversSimilarShapes) {
  EXPECT_EQ(grownSize({0, 0}, {640, 480}), Size(640, 480));
  EXPECT_EQ(grownSize({800, 300}, {400, 600}), Size(800, 600));  // twice the texels of each
  EXPECT_EQ(grownSize({100, 100}, {200, 50}), Size(200, 100));
}

TEST(TextureGrowth, CoversNoShapesThatAreVeryDifferent) {
  EXPECT_EQ(grownSize({16384, 16}, {16, 16384}), Size(16, 16384));
  EXPECT_EQ(grownSize({16, 16384}, {8192, 1024}), Size(8192, 1024));
  EXPECT_EQ(grownSize({8192, 1024}, {16384, 16}), Size(16384, 1024));
}

}  // namespace
}  // namespace gluray::present
