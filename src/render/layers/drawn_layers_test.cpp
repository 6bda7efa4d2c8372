// Layers that are blended in the order of drawing.
#include "render/testing/layer_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray {
namespace {

using glm::vec4;
using test::expectColor;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::Sheet;
using test::sheets;

uint32_t bits(const vec4& color) {
  const glm::uvec4 c(glm::round(color * 255.0f));
  return c.r | c.g << 8 | c.b << 16 | c.a << 24;
}

/// Sheets over a framebuffer of one colour and depth.
scene::Snapshot drawn(const std::vector<Sheet>& all, bool writesDepth, const vec4& there, float depth = 1) {
  auto s = sheets(all, depth);
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->of = scene::Layers::Of::drawn;
  layers->colors.assign(16 * 16, bits(there));
  layers->blending.writesDepth = writesDepth;
  layers->blending.rgb.source = scene::BlendFactor::sourceAlpha;
  layers->blending.rgb.destination = scene::BlendFactor::oneMinusSourceAlpha;
  layers->blending.alpha = layers->blending.rgb;
  layers->depthSteps = 0xFFFFFF;
  s.layers = layers;
  return s;
}

vec4 over(const vec4& there, const vec4& color) { return color * color.a + there * (1 - color.a); }

TEST(DrawnLayers, FollowTheDrawingOrderAtAnyDepth) {
  const vec4 there(0.2f, 0.4f, 0.6f, 1);
  std::vector<Sheet> all{{0.8f, kRed}, {0.1f, kGreen}, {-0.7f, kBlue}};
  do {
    vec4 expected = there;
    for (const Sheet& sheet : all) expected = over(expected, sheet.color);
    expectColor(drawn(all, false, there), expected);
  } while (std::next_permutation(all.begin(), all.end(), [](auto& a, auto& b) { return a.z < b.z; }));
}

TEST(DrawnLayers, HideLaterLayersIfTheyWriteDepth) {
  const vec4 there(0.2f, 0.4f, 0.6f, 1);
  const Sheet nearer{0.8f, kRed}, farther{-0.7f, kBlue};
  expectColor(drawn({nearer, farther}, true, there), over(there, kRed));
  expectColor(drawn({farther, nearer}, true, there), over(over(there, kBlue), kRed));
  EXPECT_FLOAT_EQ(test::trace(drawn({farther, nearer}, true, there)).depth(2, 2), 0.1f);
}

TEST(DrawnLayers, CompareDepthsAtTheFramebuffersPrecision) {
  const vec4 there(0.2f, 0.4f, 0.6f, 1);
  const std::vector<Sheet> all{{0, kRed}, {1e-8f, kBlue}};
  auto s = drawn(all, true, there);
  expectColor(s, over(there, kRed));
  s.laterWins = true;
  expectColor(s, over(over(there, kRed), kBlue));
}

TEST(DrawnLayers, AreHiddenByTheFramebuffersDepth) {
  const vec4 there(0.2f, 0.4f, 0.6f, 1);
  const std::vector<Sheet> all{{0.8f, kRed}, {0, kGreen}, {-0.7f, kBlue}};
  expectColor(drawn(all, false, there, 0.6f), over(over(there, kRed), kGreen));
  EXPECT_FALSE(test::trace(drawn(all, false, there, 0.05f)).hit(3, 3));
  EXPECT_FALSE(test::trace(drawn({{0, kRed}}, false, there, 0.5f)).hit(3, 3)) << "GL_LESS";
}

TEST(DrawnLayers, OrderedAreBlendedBackToFront) {
  const vec4 there(0.2f, 0.4f, 0.6f, 1);
  const vec4 expected = over(over(over(there, kBlue), kGreen), kRed);
  std::vector<Sheet> all{{0.8f, kRed}, {0.1f, kGreen}, {-0.7f, kBlue}};
  do {
    for (const bool writesDepth : {false, true}) {
      auto s = drawn(all, writesDepth, there);
      s.settings.transparency = Transparency::ordered;
      expectColor(s, expected);
      EXPECT_FLOAT_EQ(test::trace(s).depth(2, 2), writesDepth ? 0.1f : 1.0f);
    }
  } while (std::next_permutation(all.begin(), all.end(), [](auto& a, auto& b) { return a.z < b.z; }));
}

TEST(DrawnLayers, OrderedAtEqualDepthFollowTheDrawingOrder) {
  const vec4 there(0.2f, 0.4f, 0.6f, 1);
  auto s = drawn({{0, kRed}, {1e-8f, kBlue}}, false, there);
  s.settings.transparency = Transparency::ordered;
  expectColor(s, over(over(there, kRed), kBlue));
}

TEST(DrawnLayers, OrderedAreHiddenByTheFramebuffersDepth) {
  const vec4 there(0.2f, 0.4f, 0.6f, 1);
  auto s = drawn({{0.8f, kRed}, {-0.7f, kBlue}, {0, kGreen}}, true, there, 0.6f);
  s.settings.transparency = Transparency::ordered;
  expectColor(s, over(over(there, kGreen), kRed));
}

}  // namespace
}  // namespace gluray
