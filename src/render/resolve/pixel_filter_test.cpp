// Pixel filters against the analytic image of an edge.
#include "render/resolve/pixel_filter.h"

#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace gluray::render {
namespace {

constexpr PixelFilter kAll[] = {PixelFilter::box, PixelFilter::gauss, PixelFilter::blackmanHarris,
                                PixelFilter::mitchell};

/// The share of the filter's integral to the left of x.
double shareLeftOf(PixelFilter filter, double x) {
  const FilterCurve curve(filter);
  constexpr int kSteps = 20000;
  const double r = curve.radius();
  double left = 0, all = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double at = (2 * (i + 0.5) / kSteps - 1) * r;
    all += curve(at);
    if (at < x) left += curve(at);
  }
  return left / all;
}

/// White where x < edge, in an image of 16 x 16 pixels.
scene::Snapshot edgeAt(double edge) {
  const auto x = static_cast<float>(edge / 8 - 1);
  auto s =
      test::makeSnapshot({test::makeMesh(test::quadData({-3, -3, 0}, {x, -3, 0}, {x, 3, 0}, {-3, 3, 0}))});
  s.settings.spp = 1024;
  return s;
}

TEST(PixelFilter, OfAnEdgeIsTheFiltersIntegral) {
  for (const PixelFilter filter : kAll) {
    for (const double edge : {8.0, 8.3, 8.5}) {
      scene::Snapshot s = edgeAt(edge);
      s.settings.pixelFilter = filter;
      const test::Traced traced = test::trace(s);
      for (int x = 3; x < 13; ++x) {
        const double share = std::clamp(shareLeftOf(filter, edge - (x + 0.5)), 0.0, 1.0);
        // Rounding to bytes, and 1024 points that measure a share with an error of a few.
        EXPECT_NEAR(traced.color(x, 8).a / 255, share, 0.5 / 255 + 5.0 / 1024)
            << static_cast<int>(filter) << " " << edge << " " << x;
      }
    }
  }
}

TEST(PixelFilter, MitchellIsNegativeFarFromTheCentre) {
  const FilterCurve mitchell(PixelFilter::mitchell);
  EXPECT_NEAR(mitchell(0), 16.0 / 18, 1e-12);
  EXPECT_NEAR(mitchell(1), 1.0 / 18, 1e-12);
  EXPECT_NEAR(mitchell(2), 0, 1e-12);
  EXPECT_LT(mitchell(1.5), -0.02);
  EXPECT_GT(shareLeftOf(PixelFilter::mitchell, 1.1), 1.01);
}

TEST(PixelFilter, SamplesStartAtTheCentreAndWeightsNeverVanish) {
  for (const PixelFilter filter : kAll) {
    std::vector<glm::dvec2> unit;
    for (int i = 0; i < 1024; ++i) {
      unit.push_back(
          glm::fract(0.5 + static_cast<double>(i) * glm::dvec2(0.7548776662466927, 0.5698402909980532)));
      const FilteredSamples samples = filteredSamples(filter, unit);
      EXPECT_NEAR(samples.positions[0].x, 0.5, 1e-6);
      EXPECT_NEAR(samples.positions[0].y, 0.5, 1e-6);
      if (samples.weights.empty()) continue;
      const float sum = std::accumulate(samples.weights.begin(), samples.weights.end(), 0.0f);
      ASSERT_GE(sum, i < 8 ? 1 : 0.4f * static_cast<float>(unit.size())) << i;
    }
  }
}

TEST(PixelFilter, KeepsDepthAndWhatIsEven) {
  for (const PixelFilter filter : kAll) {
    scene::Snapshot s = edgeAt(20);
    s.settings.spp = 7;
    s.settings.pixelFilter = filter;
    s.instances[0].color = {0.2f, 0.4f, 0.6f, 1};
    const Image image = test::trace(s).image;
    s.settings.spp = 1;
    const Image one = test::trace(s).image;
    EXPECT_EQ(image.color, one.color);
    EXPECT_EQ(image.centerDepth, one.depth);
  }
}

TEST(PixelFilter, OfFloatsIsNotNegative) {
  scene::Snapshot s = edgeAt(8.3);
  s.settings.pixelFilter = PixelFilter::mitchell;
  s.settings.spp = 64;
  s.wideColors = true;
  for (const float value : test::trace(s).image.wideColor) ASSERT_GE(value, 0);
}

}  // namespace
}  // namespace gluray::render
