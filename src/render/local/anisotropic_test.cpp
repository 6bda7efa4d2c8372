// Anisotropic filtering against analytic values.
#include "render/local/anisotropic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using render::Footprint;

/// Levels of 64 x 64 texels on; value(x, y, level) of each texel.
template <class Value>
scene::Texture textureOf(int levels, Value&& value) {
  auto image = std::make_shared<scene::TextureImage>();
  image->mipmaps.resize(static_cast<size_t>(levels - 1));
  for (int level = 0; level < levels; ++level) {
    scene::TexelGrid& grid = level ? image->mipmaps[static_cast<size_t>(level - 1)] : *image;
    grid.width = grid.height = 64 >> level;
    for (int y = 0; y < grid.height; ++y)
      for (int x = 0; x < grid.width; ++x) grid.floats.emplace_back(value(x, y, level));
  }
  scene::Texture t;
  t.image = image;
  t.mipFilter = levels > 1 ? scene::MipFilter::linear : scene::MipFilter::none;
  t.lodRule = scene::LodRule::llvmpipe;
  t.maxAnisotropy = 4;
  return t;
}

float red(const scene::Texture& t, const Footprint& f, float s = 0.5f, float y = 0.5f) {
  return render::sampleTexture(t, f, {s, y, 0}).r;
}

TEST(Anisotropic, OfAConstantImageIsThatConstant) {
  const auto t = textureOf(7, [](int, int, int) { return glm::vec4(0.3f); });
  for (const double length : {0.0, 0.5, 3.0, 40.0})
    EXPECT_NEAR(red(t, {{length, 0, 0}, {0, 1, 0}}, 0.37f, 0.81f), 0.3f, 1e-6f) << length;
}

TEST(Anisotropic, TheShorterAxisChoosesTheLevel) {
  const auto t = textureOf(7, [](int, int, int level) { return glm::vec4(float(level)); });
  EXPECT_FLOAT_EQ(red(t, {{1, 0, 0}, {0, 2, 0}}), 0);
  EXPECT_FLOAT_EQ(red(t, {{4, 0, 0}, {0, 8, 0}}), 2);
  EXPECT_FLOAT_EQ(red(t, {{0, 16, 0}, {8, 0, 0}}), 3);
  EXPECT_FLOAT_EQ(red(t, {{1, 0, 0}, {0, 16, 0}}), 0) << "llvmpipe never limits the ratio";
  EXPECT_FLOAT_EQ(red(t, {{1e6, 0, 0}, {0, 1e6, 0}}), 6) << "the last level";
  auto biased = t;
  biased.lodBias = 1;
  EXPECT_FLOAT_EQ(red(biased, {{4, 0, 0}, {0, 8, 0}}), 3);
}

/// In the middle between four texels of a magnified image, all weigh the same; on a texel's centre, the
/// others within one texel weigh exp(-2).
TEST(Anisotropic, WeighsByTheDistance) {
  const auto t = textureOf(1, [](int x, int y, int) { return glm::vec4(x == 32 && y == 32 ? 1.0f : 0.0f); });
  EXPECT_NEAR(red(t, {}, 32.0f / 64, 32.0f / 64), 0.25f, 1e-5f);
  EXPECT_NEAR(red(t, {}, 32.5f / 64, 32.5f / 64), 1 / (1 + 4 * std::exp(-2.0f)), 1e-3f);
}

/// A line of texels along the long axis of the ellipse, and across it.
TEST(Anisotropic, BlursAlongTheLongerAxis) {
  const auto t = textureOf(1, [](int x, int, int) { return glm::vec4(x == 32 ? 1.0f : 0.0f); });
  const float along = red(t, {{1, 0, 0}, {0, 8, 0}}, 32.5f / 64, 32.5f / 64),
              across = red(t, {{8, 0, 0}, {0, 1, 0}}, 32.5f / 64, 32.5f / 64);
  EXPECT_GT(along, 0.4f);
  EXPECT_LT(across, 0.15f);
}

}  // namespace
}  // namespace gluray
