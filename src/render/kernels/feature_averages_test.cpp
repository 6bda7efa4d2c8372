// Auxiliary features of pixels that mix samples or layers.
#include "render/testing/layer_sheets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using Mode = scene::LightSampling::Mode;

/// The sums of a pixel, or its mean plane.
glm::vec4 featureAt(const Image& image, int x, int y) {
  const float* const at = image.wideColor.data() + 4 * static_cast<size_t>(y * image.width + x);
  return {at[0], at[1], at[2], at[3]};
}

Image featurePass(scene::Snapshot s, Mode mode) {
  s.wideColors = true;
  s.lightSampling.mode = mode;
  return test::trace(s).image;
}

/// A wall behind, of which the left half is missing, and a plate in front of its upper half.
scene::Snapshot wallAndPlate() {
  scene::Snapshot s = test::makeSnapshot(
      {test::makeMesh(test::quadData({0.03f, -3, 0}, {3, -3, 0}, {3, 3, 0}, {0.03f, 3, 0})),
       test::makeMesh(test::quadData({-3, 0.03f, 1}, {3, 0.03f, 1}, {3, 3, 1}, {-3, 3, 1}))});
  s.camera.clipFromEye = glm::perspective(glm::radians(20.0), 1.0, 0.1, 100.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld;
  s.instances[0].color = {0.8f, 0.4f, 0.2f, 1};
  s.instances[1].color = {0.1f, 0.3f, 0.5f, 1};
  s.settings.ao.enabled = true;
  s.settings.spp = 16;
  return s;
}

TEST(FeatureAverages, ColourOverCoverageIsReflectance) {
  const Image image = featurePass(wallAndPlate(), Mode::reflectance);
  ASSERT_TRUE(image.isAverages());
  int partly = 0;
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 16; ++x) {
      const glm::vec4 sums = featureAt(image, x, y);
      partly += sums.a > 0 && sums.a < 1;
      if (sums.a == 0) continue;
      EXPECT_NEAR(sums.r / sums.a, 0.8f, 1e-5f) << x << ' ' << y;
      EXPECT_NEAR(sums.b / sums.a, 0.2f, 1e-5f) << x << ' ' << y;
    }
  EXPECT_GE(partly, 6);
}

TEST(FeatureAverages, PlanesOfSeveralSurfacesAreMarked) {
  const Image image = featurePass(wallAndPlate(), Mode::geometry);
  int mixed = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const glm::vec4 plane = featureAt(image, x, y);
      mixed += plane.z > 0;
      if (plane.z > 0) { EXPECT_TRUE(y == 8 && x >= 8) << x << ' ' << y; }
      EXPECT_EQ(plane.w > 0, y >= 8 || x >= 8) << x << ' ' << y;
    }
  EXPECT_EQ(mixed, 8);
}

TEST(FeatureAverages, OneSurfaceHasThePlaneOfItsCentre) {
  scene::Snapshot s = wallAndPlate();
  s.instances[0].eyeFromObject = s.eyeFromWorld = glm::rotate(s.eyeFromWorld, 0.7, {0, 1, 0});
  s.instances.resize(1);
  const Image many = featurePass(s, Mode::geometry);
  s.settings.spp = 1;
  const Image one = featurePass(s, Mode::geometry);
  for (int y = 2; y < 14; ++y)
    for (int x = 10; x < 14; ++x) {
      const glm::vec4 a = featureAt(many, x, y), b = featureAt(one, x, y);
      EXPECT_NEAR(a.x, b.x, 1e-3f);
      EXPECT_NEAR(a.z, b.z, 0.5f);
      EXPECT_NEAR(b.z * (1 - a.w / b.w), 0, 0.2f) << "pixels";
    }
}

TEST(FeatureAverages, LayersHaveTheirOpacityAndMeans) {
  const std::vector<test::Sheet> all{{0.8f, test::kRed}, {0.1f, test::kGreen}, {-0.7f, test::kBlue}};
  scene::Snapshot s = test::sheets(all);
  s.settings.ao.enabled = true;
  glm::vec4 expected(0);
  float depths = 0, before = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    expected = test::under(expected, all[i].color);
    scene::Snapshot alone = s;
    for (size_t k = 0; k < all.size(); ++k) alone.instances[k].color.a = k == i ? 1 : 0;
    depths += (expected.a - before) * featureAt(featurePass(alone, Mode::geometry), 5, 5).w;
    before = expected.a;
  }
  for (const int spp : {1, 4}) {
    s.settings.spp = spp;
    const glm::vec4 colors = featureAt(featurePass(s, Mode::reflectance), 5, 5),
                    plane = featureAt(featurePass(s, Mode::geometry), 5, 5);
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(colors[c], expected[c], 1e-5f) << c;
    EXPECT_NEAR(plane.w, depths / expected.a, 0.05f);
    EXPECT_NEAR(plane.x, 0, 1e-5f);
    EXPECT_NEAR(plane.y, 0, 1e-5f);
    EXPECT_LT(plane.z, 0) << "one surface";
  }
}

}  // namespace
}  // namespace gluray
