// Layers of which a limited number is peeled.
#include "render/testing/layer_sheets.h"

#include <gtest/gtest.h>

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
using test::under;

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

}  // namespace
}  // namespace gluray
