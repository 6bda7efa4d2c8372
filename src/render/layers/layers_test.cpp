// Transparent layers.
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace gluray {
namespace {

using glm::vec4;

struct Sheet {
  float z;  // window depth is 0.5 - z/2
  vec4 color;
};

/// Squares over the whole window, one instance each.
scene::Snapshot sheets(const std::vector<Sheet>& all, float opaqueDepth = -1) {
  std::vector<scene::MeshPtr> meshes;
  for (const Sheet& sheet : all) meshes.push_back(test::makeMesh(test::squareData(sheet.z)));
  auto s = test::makeSnapshot(meshes);
  for (size_t i = 0; i < all.size(); ++i) {
    s.instances[i].color = all[i].color;
    s.instances[i].order = static_cast<uint32_t>(i);
  }
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.assign(16 * 16, opaqueDepth);
  s.layers = layers;
  return s;
}

/// Blends the layer's colour over `under`, as glBlendFunc would in order.
vec4 under(const vec4& front, const vec4& color) {
  const float weight = (1 - front.a) * color.a;
  return front + weight * vec4(glm::vec3(color), 1);
}

void expectColor(const scene::Snapshot& s, const vec4& expected) {
  const auto traced = test::trace(s);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      ASSERT_LE(test::difference(traced.color(x, y), glm::round(expected * 255.0f)), 1) << x << ' ' << y;
}

constexpr vec4 kRed(1, 0, 0, 0.5f), kGreen(0, 1, 0, 0.25f), kBlue(0, 0, 1, 0.75f);

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

// --- In the order of drawing
// ---------------------------------------------------------------------------------

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

// --- Sums --------------------------------------------------------------------------------------------------

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

/// Sheets in the order of drawing; those that `peels` peels do not take are blended in that order.
scene::Snapshot peeled(uint32_t peels, const std::vector<Sheet>& all, float opaqueDepth = -1) {
  auto s = sheets(all, opaqueDepth);
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->peels = peels;
  s.layers = layers;
  return s;
}

constexpr vec4 kWhite(1, 1, 1, 0.4f), kGray(0.3f, 0.3f, 0.3f, 0.8f);
const std::vector<Sheet> kMixed{{0.2f, kRed}, {-0.7f, kBlue}, {0, kGreen}, {0.8f, kWhite}, {-0.4f, kGray}};

TEST(PeeledLayers, TheRestFollowsTheDrawingOrder) {
  // White is nearest, blue farthest; of the others gray was drawn last.
  expectColor(peeled(1, kMixed),
              under(under(under(under(under(vec4(0), kWhite), kGray), kGreen), kRed), kBlue));
}

TEST(PeeledLayers, TheFirstPeelTakesTheOpaqueSurfaceAsFarthest) {
  expectColor(peeled(1, kMixed, 0.99f),
              under(under(under(under(under(vec4(0), kWhite), kGray), kGreen), kBlue), kRed));
}

TEST(PeeledLayers, ASingleRestLayerHasNoOrder) {
  const vec4 inOrder = under(under(under(under(under(vec4(0), kWhite), kRed), kGreen), kGray), kBlue);
  for (const uint32_t peels : {2u, 3u, 100u}) expectColor(peeled(peels, kMixed), inOrder);
  expectColor(peeled(3, kMixed, 0.99f), inOrder);
}

TEST(PeeledLayers, OpaqueRestLayersDoNotHideLaterOnes) {
  const vec4 wall(0.2f, 0.4f, 0.6f, 1);
  const std::vector<Sheet> all{{0, wall}, {0.5f, kRed}, {-0.5f, kGreen}, {0.8f, kWhite}, {-0.7f, kBlue}};
  expectColor(peeled(1, all), under(under(under(under(vec4(0), kWhite), kGreen), kRed), wall));
  // Among peeled layers it does.
  expectColor(peeled(3, all), under(under(under(vec4(0), kWhite), kRed), wall));
}

TEST(PeeledLayers, LayersAtEqualDepthCountOnce) {
  const vec4 both = glm::max(under(vec4(0), kRed), under(vec4(0), kBlue));
  expectColor(peeled(1, {{0.5f, kRed}, {0.5f, kBlue}, {0, kGreen}, {-0.2f, kGray}, {-0.5f, kWhite}}),
              under(under(under(both, kGray), kGreen), kWhite));
}

TEST(Layers, RequireOpaqueDepths) {
  auto s = sheets({{0, kRed}});
  s.layers = std::make_shared<scene::Layers>();
  EXPECT_THROW(test::trace(s), std::runtime_error);
}

}  // namespace
}  // namespace gluray
