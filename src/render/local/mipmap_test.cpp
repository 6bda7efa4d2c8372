// Levels of detail against closed-form values.
#include "render/local/mipmap.h"

#include "render/local/texture_lookup.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using render::Footprint;
using scene::Filter;
using scene::LodRule;
using scene::MipFilter;

// 16 x 16 texels and four smaller levels; the texels of level i are i*40.
scene::Texture pyramid(MipFilter mip, LodRule rule = LodRule::specified) {
  auto image = std::make_shared<scene::TextureImage>();
  const auto fill = [](scene::TexelGrid& grid, int side, uint32_t value) {
    grid.width = grid.height = side;
    grid.texels.assign(static_cast<size_t>(side * side), value | 0xFF000000u);
  };
  fill(*image, 16, 0);
  image->mipmaps.resize(4);
  for (uint32_t i = 1; i <= 4; ++i) fill(image->mipmaps[i - 1], 16 >> i, i * 40);
  scene::Texture t;
  t.image = image;
  t.mipFilter = mip;
  t.lodRule = rule;
  return t;
}

Footprint across(double rho) { return {{rho, 0, 0}, {0, rho, 0}}; }

double levelSeen(const scene::Texture& t, const Footprint& footprint) {
  return static_cast<double>(render::sampleTexture(t, footprint, {0.3f, 0.6f, 0}).r) * 255 / 40;
}

TEST(Mipmap, NearestLevelAsSpecified) {
  const auto t = pyramid(MipFilter::nearest);
  EXPECT_TRUE(render::chooseLevel(t, across(1)).magnified);
  EXPECT_EQ(render::chooseLevel(t, across(1.4)).level, 0);  // d = ceil(lambda + 1/2) - 1
  EXPECT_FALSE(render::chooseLevel(t, across(1.4)).magnified);
  EXPECT_EQ(render::chooseLevel(t, across(1.42)).level, 1);
  EXPECT_EQ(render::chooseLevel(t, across(4)).level, 2);
  EXPECT_EQ(render::chooseLevel(t, across(1000)).level, 4);
}

TEST(Mipmap, BlendedLevelsAsSpecified) {
  const auto t = pyramid(MipFilter::linear);
  EXPECT_NEAR(levelSeen(t, across(2)), 1, 1e-4);
  EXPECT_NEAR(levelSeen(t, across(std::exp2(1.25))), 1.25, 1e-4);
  EXPECT_NEAR(levelSeen(t, across(std::exp2(2.5))), 2.5, 1e-4);
  EXPECT_NEAR(levelSeen(t, across(1e6)), 4, 1e-4);
}

TEST(Mipmap, TheLongerDerivativeCounts) {
  const Footprint slanted{{3, 4, 0}, {1, 1, 0}};
  EXPECT_NEAR(levelSeen(pyramid(MipFilter::linear), slanted), std::log2(5), 1e-4);
}

// Values of llvmpipe in Mesa 22.3.
TEST(Mipmap, LlvmpipesPiecewiseLinearLogarithm) {
  auto t = pyramid(MipFilter::linear, LodRule::llvmpipe);
  EXPECT_TRUE(render::chooseLevel(t, across(0.99)).magnified);
  EXPECT_NEAR(levelSeen(t, across(2)), 1, 1e-4);
  EXPECT_NEAR(levelSeen(t, across(3)), 1.5625, 1e-4);   // 9 = 2^3 * 1.125
  EXPECT_NEAR(levelSeen(t, across(5)), 2.28125, 1e-4);  // 25 = 2^4 * 1.5625
  t.minFilter = Filter::nearest, t.mipFilter = MipFilter::nearest;
  EXPECT_FALSE(render::chooseLevel(t, across(1.2)).magnified);  // c = 0 for all filters
}

TEST(Mipmap, BiasAndLimits) {
  for (const LodRule rule : {LodRule::specified, LodRule::llvmpipe}) {
    auto t = pyramid(MipFilter::linear, rule);
    t.lodBias = 1;
    EXPECT_NEAR(levelSeen(t, across(2)), 2, 1e-4);
    t.lodBias = -3;
    EXPECT_TRUE(render::chooseLevel(t, across(4)).magnified);
    t.lodBias = 0;
    t.minLod = 3;
    EXPECT_NEAR(levelSeen(t, across(1)), 3, 1e-4);
    t.minLod = 1e30f;  // any float is legal
    EXPECT_NEAR(levelSeen(t, across(1)), 4, 1e-4);
    t.minLod = 0, t.maxLod = 1;
    EXPECT_NEAR(levelSeen(t, across(16)), 1, 1e-4);
  }
}

TEST(Mipmap, SharpMinificationStartsLater) {
  auto t = pyramid(MipFilter::nearest);
  t.minFilter = Filter::nearest;
  EXPECT_TRUE(render::chooseLevel(t, across(1.41)).magnified);  // c = 1/2: GL 2.1, 3.8.9
  EXPECT_FALSE(render::chooseLevel(t, across(1.42)).magnified);
  t.magFilter = Filter::nearest;
  EXPECT_FALSE(render::chooseLevel(t, across(1.1)).magnified);
}

TEST(Mipmap, DegenerateFootprints) {
  const auto t = pyramid(MipFilter::linear);
  const Footprint broken{{NAN, 0, 0}, {0, INFINITY, 0}};
  EXPECT_EQ(render::chooseLevel(t, broken).level, 0);
}

TEST(CubeMap, FacesAndCoordinates) {
  const struct {
    glm::dvec3 direction;
    int face;
    double s, t;
  } rows[] = {
      {{1, 0.5, -0.25}, 0, 0.625, 0.25}, {{-2, 1, -0.5}, 1, 0.375, 0.25},
      {{0.5, 1, -0.25}, 2, 0.75, 0.375}, {{0.5, -1, -0.25}, 3, 0.75, 0.625},
      {{0.5, -0.5, 2}, 4, 0.625, 0.625}, {{0.5, -0.5, -2}, 5, 0.375, 0.625},
  };
  for (const auto& row : rows) {
    EXPECT_EQ(render::cubeFace(row.direction), row.face);
    const glm::dvec2 st = render::coordinatesInFace(row.face, row.direction);
    EXPECT_DOUBLE_EQ(st.x, row.s) << row.face;
    EXPECT_DOUBLE_EQ(st.y, row.t) << row.face;
  }
}

}  // namespace
}  // namespace gluray
