// Known answers of blending with eight bits per channel: one surface over a framebuffer of one colour.
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

using scene::BlendEquation;
using scene::Blending;
using Factor = scene::BlendFactor;

constexpr uint32_t rgba(uint32_t r, uint32_t g, uint32_t b, uint32_t a) {
  return r | g << 8 | b << 16 | a << 24;
}

Blending by(Factor source, Factor destination, BlendEquation equation = BlendEquation::add) {
  Blending blending;
  blending.rgb = blending.alpha = {equation, source, destination};
  blending.constant = {0.2f, 0.4f, 0.6f, 0.8f};
  return blending;
}

uint32_t blended(const Blending& blending, const scene::ColorWrites& writes, uint32_t source,
                 uint32_t there) {
  auto s = test::makeSnapshot({test::makeMesh(test::squareData(0))});
  s.instances[0].color =
      glm::vec4(source & 255, source >> 8 & 255, source >> 16 & 255, source >> 24) / 255.0f;
  s.colorWrites = writes;
  auto layers = std::make_shared<scene::Layers>();
  layers->of = scene::Layers::Of::drawn;
  layers->opaqueDepth.assign(16 * 16, 1.0f);
  layers->colors.assign(16 * 16, there);
  layers->blending = blending;
  s.layers = layers;
  return test::trace(s).image.color[5 * 16 + 7];
}

uint32_t result(const Blending& blending, uint32_t source = rgba(200, 100, 50, 51),
                uint32_t there = rgba(10, 20, 240, 102)) {
  return blended(blending, {}, source, there);
}

TEST(Blend, OfFactors) {
  EXPECT_EQ(result(by(Factor::one, Factor::zero)), rgba(200, 100, 50, 51));
  EXPECT_EQ(result(by(Factor::zero, Factor::one)), rgba(10, 20, 240, 102));
  EXPECT_EQ(result(by(Factor::one, Factor::one)), rgba(210, 120, 255, 153));
  EXPECT_EQ(result(by(Factor::sourceAlpha, Factor::oneMinusSourceAlpha)), rgba(48, 36, 202, 92));
  EXPECT_EQ(result(by(Factor::destinationAlpha, Factor::oneMinusDestinationAlpha)), rgba(86, 52, 164, 81));
  EXPECT_EQ(result(by(Factor::destinationColor, Factor::zero)), rgba(8, 8, 47, 20));
  EXPECT_EQ(result(by(Factor::zero, Factor::oneMinusSourceColor)), rgba(2, 12, 193, 82));
  EXPECT_EQ(result(by(Factor::sourceAlphaSaturate, Factor::zero)), rgba(40, 20, 10, 51));
  EXPECT_EQ(result(by(Factor::constantColor, Factor::zero)), rgba(40, 40, 30, 41));
  EXPECT_EQ(result(by(Factor::oneMinusConstantAlpha, Factor::zero)), rgba(40, 20, 10, 10));
}

TEST(Blend, OfEquations) {
  EXPECT_EQ(result(by(Factor::one, Factor::one, BlendEquation::subtract)), rgba(190, 80, 0, 0));
  EXPECT_EQ(result(by(Factor::one, Factor::one, BlendEquation::reverseSubtract)), rgba(0, 0, 190, 51));
  EXPECT_EQ(result(by(Factor::zero, Factor::zero, BlendEquation::min)), rgba(10, 20, 50, 51));
  EXPECT_EQ(result(by(Factor::zero, Factor::zero, BlendEquation::max)), rgba(200, 100, 240, 102));
}

/// 26 * 152 / 255 = 15.498 and 229 * 152 / 255 = 136.502: the second is rounded down.
TEST(Blend, RoundsEachProductAsMesaDoes) {
  const Blending blending = by(Factor::sourceAlpha, Factor::oneMinusSourceAlpha);
  EXPECT_EQ(result(blending, rgba(152, 0, 9, 26), rgba(152, 152, 0, 0)) & 0xffffffu, rgba(151, 136, 1, 0));
}

TEST(Blend, AlphaSeparately) {
  Blending blending = by(Factor::sourceAlpha, Factor::oneMinusSourceAlpha);
  blending.alpha = {BlendEquation::add, Factor::zero, Factor::one};
  EXPECT_EQ(result(blending), rgba(48, 36, 202, 102));
  blending.alpha = {BlendEquation::max, Factor::zero, Factor::zero};
  EXPECT_EQ(result(blending), rgba(48, 36, 202, 102));
  blending.rgb.source = blending.alpha.source = Factor::sourceAlphaSaturate;
  blending.alpha.equation = BlendEquation::add;
  blending.alpha.destination = blending.rgb.destination = Factor::zero;
  EXPECT_EQ(result(blending) >> 24, 51u);
}

TEST(Blend, LeavesChannelsThatAreNotWritten) {
  const Blending blending = by(Factor::one, Factor::one);
  EXPECT_EQ(blended(blending, {.red = false, .blue = false}, rgba(1, 2, 3, 4), rgba(10, 20, 30, 40)),
            rgba(10, 22, 30, 44));
}

TEST(Blend, LeavesTheAlphaOfFramebuffersWithoutOne) {
  Blending blending = by(Factor::sourceAlpha, Factor::oneMinusSourceAlpha);
  blending.hasAlpha = false;
  EXPECT_EQ(result(blending, rgba(255, 255, 255, 51), rgba(0, 0, 0, 255)), rgba(51, 51, 51, 255));
}

}  // namespace
}  // namespace gluray
