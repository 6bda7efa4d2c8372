// Sums of layers.
#include "render/testing/layer_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace gluray {
namespace {

using glm::vec4;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::Sheet;
using test::sheets;
using test::under;

scene::Snapshot summed(const std::vector<Sheet>& all, float opaqueDepth = -1) {
  auto s = sheets(all, opaqueDepth);
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->of = scene::Layers::Of::sums;
  s.layers = layers;
  return s;
}

void expectSums(const scene::Snapshot& s, const std::vector<Sheet>& counted) {
  vec4 sums(0);
  float through = 1;
  for (const Sheet& sheet : counted) {
    sums += sheet.color.a * vec4(glm::vec3(sheet.color), 1);
    through *= 1 - sheet.color.a;
  }
  const Image image = test::trace(s).image;
  ASSERT_EQ(image.planes, Image::kSums);
  for (size_t pixel = 0; pixel < 16 * 16; ++pixel) {
    for (int c = 0; c < 4; ++c)
      ASSERT_NEAR(image.wideColor[4 * pixel + static_cast<size_t>(c)], sums[c], 1e-5f) << pixel;
    ASSERT_NEAR(image.transmittance[pixel], through, 1e-5f) << pixel;
  }
}

TEST(LayerSums, AreIndependentOfTheOrder) {
  std::vector<Sheet> all{{0.8f, kRed}, {0.1f, kGreen}, {-0.7f, kBlue}};
  do expectSums(summed(all), all);
  while (std::next_permutation(all.begin(), all.end(), [](auto& a, auto& b) { return a.z < b.z; }));
}

TEST(LayerSums, IncludeAllLayersAtEqualDepth) {
  const std::vector<Sheet> all{{0, kRed}, {0, kRed}, {0, kBlue}};
  expectSums(summed(all), all);
}

TEST(LayerSums, ContinueBehindOpaqueLayers) {
  const std::vector<Sheet> all{{0.5f, {0.2f, 0.4f, 0.6f, 1}}, {0, kRed}};
  expectSums(summed(all), all);
}

TEST(LayerSums, EndAtTheOpaqueSurface) {
  const std::vector<Sheet> all{{0.8f, kRed}, {0.1f, kGreen}, {-0.7f, kBlue}};
  expectSums(summed(all, 0.5f), {all[0], all[1]});
  expectSums(summed(all, 0.05f), {});
}

TEST(LayerSums, OrderedHaveTheColourOfTheLayersOverEachOther) {
  const vec4 expected = under(under(under(vec4(0), kRed), kGreen), kBlue);
  std::vector<Sheet> all{{0.8f, kRed}, {0.1f, kGreen}, {-0.7f, kBlue}};
  do {
    auto s = summed(all);
    s.settings.transparency = Transparency::ordered;
    const Image image = test::trace(s).image;
    ASSERT_NEAR(image.transmittance[0], 1 - expected.a, 1e-5f);
    ASSERT_NEAR(image.wideColor[3], kRed.a + kGreen.a + kBlue.a, 1e-5f);
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(image.wideColor[static_cast<size_t>(c)] / image.wideColor[3], expected[c] / expected.a,
                  1e-5f);
  } while (std::next_permutation(all.begin(), all.end(), [](auto& a, auto& b) { return a.z < b.z; }));
}

TEST(LayerSums, OrderedOfNoLayersHaveFullTransmittance) {
  auto s = summed({});
  s.settings.transparency = Transparency::ordered;
  const Image image = test::trace(s).image;
  EXPECT_EQ(image.wideColor, std::vector<float>(size_t{4} * 16 * 16, 0.0f));
  EXPECT_EQ(image.transmittance, std::vector<float>(16 * 16, 1.0f));
}

TEST(LayerSums, OfNoLayersHaveFullTransmittance) {
  const Image image = test::trace(summed({})).image;
  EXPECT_EQ(image.wideColor, std::vector<float>(size_t{4} * 16 * 16, 0.0f));
  EXPECT_EQ(image.transmittance, std::vector<float>(16 * 16, 1.0f));
}

}  // namespace
}  // namespace gluray
