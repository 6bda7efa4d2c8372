// Layers that are blended in the order of drawing with colours of floats.
#include "render/testing/layer_sheets.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace gluray {
namespace {

using glm::vec4;
using scene::BlendEquation;
using Factor = scene::BlendFactor;
using test::Sheet;

scene::Snapshot blended(const std::vector<Sheet>& all, const vec4& there, Factor source, Factor destination,
                        bool halfFloats = false) {
  auto s = test::sheets(all, 1);
  s.wideColors = true;
  scene::FragmentShading& program = s.shadings[0].fragment;  // fixed function clamps colours
  program.model = scene::FragmentShading::Model::unlit,
  program.color = scene::FragmentShading::Color::vertices;
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->of = scene::Layers::Of::drawn;
  layers->floatColors.assign(16 * 16, there);
  layers->halfFloats = halfFloats;
  layers->blending.rgb = layers->blending.alpha = {BlendEquation::add, source, destination};
  layers->blending.constant = {0.25f, 0.5f, 0.75f, 1};
  layers->blending.writesDepth = false;
  s.layers = layers;
  return s;
}

void expectFloats(const scene::Snapshot& s, const vec4& expected) {
  const Image image = test::trace(s).image;
  ASSERT_EQ(image.planes, Image::kWide);
  for (size_t pixel = 0; pixel < 16 * 16; ++pixel)
    for (int c = 0; c < 4; ++c)
      ASSERT_FLOAT_EQ(image.wideColor[4 * pixel + static_cast<size_t>(c)], expected[c]) << pixel << ' ' << c;
}

constexpr vec4 kBright(4, 2, 1, 0.5f);

TEST(FloatLayers, AreNotClamped) {
  const std::vector<Sheet> sheets{{0, kBright}, {0.5f, {-1, 0, 8, 0.25f}}};
  expectFloats(blended(sheets, {3, 5, 7, 1}, Factor::sourceAlpha, Factor::oneMinusSourceAlpha),
               {0.75f * 3.5f - 0.25f, 0.75f * 3.5f, 0.75f * 4 + 2, 0.75f * 0.75f + 0.0625f});
  expectFloats(blended({{0, kBright}}, {3, 5, -7, 1}, Factor::one, Factor::one), {7, 7, -6, 1.5f});
}

TEST(FloatLayers, OfFactors) {
  const std::vector<Sheet> one{{0, kBright}};
  const vec4 there(3, 5, 7, 0.25f);
  expectFloats(blended(one, there, Factor::oneMinusDestinationColor, Factor::zero), {-8, -8, -6, 0.375f});
  expectFloats(blended(one, there, Factor::constantColor, Factor::zero), {1, 1, 0.75f, 0.5f});
  expectFloats(blended(one, there, Factor::sourceAlphaSaturate, Factor::zero), {2, 1, 0.5f, 0.5f});
}

TEST(FloatLayers, LeaveWhatTheyDoNotMeet) {
  auto s = blended({{-0.9f, kBright}}, {3, 5, 7, 1}, Factor::one, Factor::one);
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->opaqueDepth.assign(16 * 16, 0.5f);
  s.layers = layers;
  EXPECT_FALSE(test::trace(s).hit(3, 3));
}

/// Of 1 + 2^-11 and the next half floats, 1 and 1 + 2^-10, the first is nearer to 0.
TEST(FloatLayers, OfSixteenBitsAreRoundedTowardsZero) {
  const vec4 color(1 + 0x1.8p-11f, -1 - 0x1.8p-11f, 0x1.ep-24f, 1e6f);
  expectFloats(blended({{0, color}}, vec4(0), Factor::one, Factor::zero, true), {1, -1, 0x1p-24f, 65504});
  expectFloats(blended({{0, color}}, vec4(0), Factor::one, Factor::zero), color);
}

TEST(FloatLayers, RequireColorsOfTheirKind) {
  auto s = blended({{0, kBright}}, vec4(0), Factor::one, Factor::zero);
  s.wideColors = false;
  EXPECT_THROW(test::trace(s), std::runtime_error);
}

}  // namespace
}  // namespace gluray
