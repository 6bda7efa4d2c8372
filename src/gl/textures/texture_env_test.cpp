// Texture environments: their effect on alpha, and the units that combiners read.
#include "gl/textures/texture_env.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using scene::Combine;
using scene::TexEnv;

scene::Texture textureOf(uint8_t unit, bool opaque, TexEnv env = TexEnv::modulate) {
  auto image = std::make_shared<scene::TextureImage>();
  image->opaque = opaque;
  scene::Texture t;
  t.image = image;
  t.unit = unit;
  t.env = env;
  return t;
}

scene::Texture combining(Combine::Function function, uint8_t a, uint8_t b,
                         Combine::Operand operand = Combine::alpha) {
  scene::Texture t = textureOf(0, true, TexEnv::combine);
  t.combine.alphaPart.function = function;
  t.combine.alphaPart.arguments = {{{a, operand}, {b, operand}, {Combine::constant, Combine::alpha}}};
  t.envColor.a = 0.5f;
  return t;
}

TEST(TextureEnv, OpaqueImagesKeepColoursOpaque) {
  EXPECT_TRUE(keepOpaque({}));
  EXPECT_TRUE(keepOpaque({textureOf(0, true), textureOf(1, true)}));
  EXPECT_FALSE(keepOpaque({textureOf(0, true), textureOf(1, false)}));
  EXPECT_TRUE(keepOpaque({textureOf(0, false, TexEnv::decal)}));
}

TEST(TextureEnv, IntensityBlendsTheConstantAlpha) {
  auto t = textureOf(0, true, TexEnv::blend);
  auto image = std::make_shared<scene::TextureImage>(*t.image);
  image->baseFormat = scene::BaseFormat::intensity;
  t.image = image;
  t.envColor.a = 0.5f;
  EXPECT_FALSE(keepOpaque({t}));
  t.envColor.a = 1;
  EXPECT_TRUE(keepOpaque({t}));
}

TEST(TextureEnv, EvaluatesTheAlphaOfCombiners) {
  EXPECT_TRUE(keepOpaque({combining(Combine::modulate, Combine::texture, Combine::previous)}));
  EXPECT_FALSE(keepOpaque({combining(Combine::modulate, Combine::constant, Combine::previous)}));
  EXPECT_TRUE(keepOpaque({combining(Combine::add, Combine::constant, Combine::previous)}));
  EXPECT_FALSE(keepOpaque({combining(Combine::subtract, Combine::texture, Combine::previous)}));
  EXPECT_FALSE(
      keepOpaque({combining(Combine::replace, Combine::texture, Combine::previous, Combine::oneMinusAlpha)}));
  auto half = combining(Combine::replace, Combine::constant, Combine::previous);
  half.combine.alphaPart.scale = 2;
  EXPECT_TRUE(keepOpaque({half}));
  auto product = textureOf(0, true, TexEnv::combine);
  product.combine.rgb.function = Combine::dot3Rgba;
  EXPECT_FALSE(keepOpaque({product}));
}

TEST(TextureEnv, KnowsWhichUnitsACombinerReads) {
  EXPECT_EQ(otherUnits(textureOf(2, true)), 0u);
  auto t = combining(Combine::replace, Combine::textureUnit + 3, Combine::textureUnit + 5);
  EXPECT_EQ(otherUnits(t), 8u) << "the second argument is not used";
  t.combine.alphaPart.function = Combine::add;
  EXPECT_EQ(otherUnits(t), 8u + 32u);
}

}  // namespace
}  // namespace gluray::gl
