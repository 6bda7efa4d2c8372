// Transparent layers.
#include "render/testing/layer_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
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
using test::under;

TEST(Layers, AreCompositedFrontToBack) {
  const vec4 expected = under(under(under(vec4(0), kRed), kGreen), kBlue);
  std::vector<Sheet> all{{0.8f, kRed}, {0.1f, kGreen}, {-0.7f, kBlue}};
  do expectColor(sheets(all), expected);
  while (std::next_permutation(all.begin(), all.end(), [](auto& a, auto& b) { return a.z < b.z; }));
}

TEST(Layers, DepthIsTheFirstLayers) {
  const auto traced = test::trace(sheets({{-0.5f, kGreen}, {0.5f, kRed}}));
  EXPECT_FLOAT_EQ(traced.depth(5, 5), 0.25f);
}

TEST(Layers, OpaqueSurfacesHideLayersBehind) {
  const std::vector<Sheet> all{{0.8f, kRed}, {0.1f, kGreen}, {-0.7f, kBlue}};
  expectColor(sheets(all, 0.5f), under(under(vec4(0), kRed), kGreen));
  expectColor(sheets(all, 0.05f), vec4(0));
  EXPECT_FALSE(test::trace(sheets(all, 0.05f)).hit(3, 3));
}

TEST(Layers, OpaqueDepthIsThePixelsOwn) {
  auto s = sheets({{0, kRed}});
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->opaqueDepth[7 * 16 + 3] = 0.25f;
  s.layers = layers;
  const auto traced = test::trace(s);
  EXPECT_FALSE(traced.hit(3, 7));
  EXPECT_TRUE(traced.hit(7, 3));
}

TEST(Layers, OpaqueLayersEndTheRay) {
  const vec4 wall(0.2f, 0.4f, 0.6f, 1);
  expectColor(sheets({{0.5f, kRed}, {0, wall}, {-0.5f, kBlue}}), under(under(vec4(0), kRed), wall));
}

TEST(Layers, AtEqualDepthEveryChannelKeepsTheLargest) {
  const vec4 expected = glm::max(under(vec4(0), kRed), under(vec4(0), kBlue));
  expectColor(sheets({{0, kRed}, {0, kBlue}}), expected);
  expectColor(sheets({{0, kRed}, {0, kBlue}, {-0.5f, kGreen}}), under(expected, kGreen));
}

TEST(Layers, CulledLayersAreIgnored) {
  auto s = sheets({{0.5f, kRed}, {0, kGreen}});
  s.instances[0].cull = scene::CullFace::front;
  expectColor(s, under(vec4(0), kGreen));
}

TEST(Layers, ManyThinLayers) {
  std::vector<Sheet> all;
  vec4 expected(0);
  for (int i = 0; i < 200; ++i) {
    const vec4 color(i % 2, 0.5f, 0.25f, 0.01f);
    all.push_back({0.9f - 0.009f * static_cast<float>(i), color});
    expected = under(expected, color);
  }
  expectColor(sheets(all), expected);
}

TEST(Layers, LayersOfOneMesh) {
  test::MeshData data = test::squareData(0.5f);
  const test::MeshData behind = test::squareData(-0.5f);
  data.positions.insert(data.positions.end(), behind.positions.begin(), behind.positions.end());
  for (const uint32_t i : behind.indices) data.indices.push_back(i + 4);
  auto s = sheets({{0, kRed}});
  s.instances[0].mesh = test::makeMesh(data);
  expectColor(s, under(under(vec4(0), kRed), kRed));
}

TEST(WideColors, AreTheNearestSurfaces) {
  auto s = sheets({{0.8f, {0.25f, 0.5f, 0.75f, 1}}, {0, kRed}});
  s.layers.reset();
  s.wideColors = true;
  const Image image = test::trace(s).image;
  ASSERT_EQ(image.planes, Image::kWide);
  for (size_t pixel = 0; pixel < 16 * 16; ++pixel)
    for (size_t c = 0; c < 4; ++c)
      ASSERT_FLOAT_EQ(image.wideColor[4 * pixel + c], static_cast<float>(c + 1) / 4) << pixel;
}

TEST(Layers, RequireOpaqueDepths) {
  auto s = sheets({{0, kRed}});
  s.layers = std::make_shared<scene::Layers>();
  EXPECT_THROW(test::trace(s), std::runtime_error);
}

}  // namespace
}  // namespace gluray
