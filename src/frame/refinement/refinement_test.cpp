// Means of passes: equal to one image of as many samples; known answers; noise against the true error.
#include "frame/refinement/refinement.h"

#include "base/sanitized.h"
#include "frame/testing/lit_scene.h"
#include "render/resolve/wavelet.h"
#include "scene/backdrop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::frame {
namespace {

using test::difference, test::litScene, test::Refined;

Image reference(scene::Snapshot s, int rays) {
  s.settings.ao.samples = rays;
  return test::CountingTrace().image(s);
}

TEST(Refinement, PassesEqualOneImageOfAsManySamples) {
  scene::Snapshot s = litScene();
  s.instances[0].color = {0.9f, 0.5f, 0.2f, 1};
  s.wideColors = true;
  const Refined refined(s, 8);
  EXPECT_TRUE(refined.image.has(Plane::wideColor));
  EXPECT_LT(difference(refined.image, reference(s, 32)), 1e-6);
  s.wideColors = false;
  const Image one = reference(s, 32), eight = Refined(s, 8).image;
  EXPECT_EQ(eight.planes, one.planes);
  EXPECT_EQ(eight.depth, one.depth);
  int differing = 0;
  for (size_t i = 0; i < one.color.size(); ++i) differing += eight.color[i] != one.color[i];
  EXPECT_LE(differing, 5) << "rounding of bytes";
}

TEST(Refinement, RefinesEachSampleOfMultisampledFramebuffers) {
  scene::Snapshot s = litScene();
  s.samples = 4;
  s.samplePositions = {{0.4f, 0.1f}, {0.9f, 0.4f}, {0.1f, 0.6f}, {0.6f, 0.9f}};
  s.settings.shading = ShadingRate::sample;
  const Image truth = reference(s, 1024), once = reference(s, 4), refined = Refined(s, 16).image;
  EXPECT_EQ(refined.samples, 4);
  EXPECT_EQ(refined.planes, Image::kColorDepth);
  EXPECT_EQ(refined.depth, once.depth);
  EXPECT_LT(difference(refined, truth), 0.5 * difference(once, truth));
}

TEST(Refinement, ConvergesToTheKnownAnswer) {
  const Refined refined(litScene(test::Hides::half), 256);
  for (const uint32_t color : refined.image.color)
    EXPECT_NEAR(static_cast<float>(color & 255) / 255, 0.5f, 0.01f);
  EXPECT_LT(refined.refinement.noise(), 0.01);
}

TEST(Refinement, EstimatesItsError) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = litScene();
  s.wideColors = true;
  const Image truth = reference(s, 4096);
  for (const int passes : {4, 16, 64}) {
    const Refined refined(s, passes);
    const double error = difference(refined.image, truth), estimate = refined.refinement.noise();
    EXPECT_GT(estimate, 0.8 * error) << passes;
    EXPECT_LT(estimate, 2 * error) << passes;
  }
}

TEST(Refinement, NoiseNeedsTwoPasses) {
  const scene::Snapshot s = litScene();
  EXPECT_TRUE(std::isinf(Refined(s, 1).refinement.noise()));
  EXPECT_GT(Refined(s, 2).refinement.noise(), 0);
}

/// A scene in which light changes nothing, of many colours.
scene::Snapshot colourfulScene(float alpha = 0.7f) {
  gluray::test::MeshData data = gluray::test::squareData();
  data.colors = {{0.1f, 0.2f, 0.7f, 1}, {1, 0.33f, 0, 1}, {0.5f, 0.77f, 0.3f, 1}, {0, 1, 0.123f, alpha}};
  scene::Snapshot s = gluray::test::makeSnapshot({gluray::test::makeMesh(data)}, 48);
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 2;
  return s;
}

TEST(Refinement, KeepsTheLocalLookToTheBit) {
  scene::Snapshot s = colourfulScene();
  const Refined refined(s, 7);
  EXPECT_EQ(refined.refinement.noise(), 0);
  s.settings.ao.enabled = false;
  const Image look = test::CountingTrace().image(s);
  EXPECT_EQ(refined.image.color, look.color);
  EXPECT_EQ(refined.image.depth, look.depth);
}

TEST(Refinement, KeepsTheLookOfAveragesAndLayers) {
  for (const bool layered : {false, true}) {
    scene::Snapshot s = colourfulScene();
    if (layered) {
      auto layers = std::make_shared<scene::Layers>();
      layers->opaqueDepth.assign(48 * 48, -1.0f);
      s.layers = layers;
    } else {
      s.settings.spp = 4;
      s.instances[0].mesh = gluray::test::makeMesh(gluray::test::squareData(0.2f));
      s.instances[0].color = {0.3f, 0.6f, 0.9f, 1};
    }
    const Image refined = Refined(s, 5).image;
    s.settings.ao.enabled = false;
    const Image look = test::CountingTrace().image(s);
    EXPECT_EQ(refined.planes, look.planes);
    EXPECT_EQ(refined.color, look.color);
    EXPECT_EQ(refined.depth, look.depth);
    EXPECT_EQ(refined.centerDepth, look.centerDepth);
  }
}

TEST(Refinement, KeepsTheLookOverABackdrop) {
  scene::Snapshot s = colourfulScene(1);
  s.backdrop = std::make_shared<scene::Backdrop>();
  s.settings.background.kind = BackgroundKind::color;
  s.settings.background.color = {0, 0, 1};
  const Image refined = Refined(s, 5).image;
  s.settings.ao.enabled = false;
  const Image look = test::CountingTrace().image(s);
  EXPECT_TRUE(look.isAverages());
  EXPECT_EQ(refined.color, look.color);
  EXPECT_EQ(refined.depth, look.depth);
}

TEST(Refinement, SumsOfLayersStayFloats) {
  scene::Snapshot s = colourfulScene();
  auto layers = std::make_shared<scene::Layers>();
  layers->of = scene::Layers::Of::sums;
  layers->opaqueDepth.assign(48 * 48, -1.0f);
  s.layers = layers;
  const Image refined = Refined(s, 3).image;
  s.settings.ao.enabled = false;
  const Image look = test::CountingTrace().image(s);
  EXPECT_EQ(refined.planes, Image::kSums);
  EXPECT_EQ(refined.wideColor, look.wideColor);
  EXPECT_EQ(refined.transmittance, look.transmittance);
}

TEST(Refinement, MissesHaveTheirColour) {
  scene::Snapshot s = litScene();
  s.instances.erase(s.instances.begin());
  Image image;
  image.missColor = 0x12345678;
  Refinement refinement;
  test::CountingTrace tracer;
  Refiner refiner(s, refinement);
  scene::TraceCost cost;
  std::string error;
  ASSERT_TRUE(refiner.pass(tracer.trace, image.missColor, cost, error));
  refiner.show(image);
  int misses = 0;
  for (size_t i = 0; i < image.color.size(); ++i) {
    if (image.depth[i] != Image::kMiss) continue;
    EXPECT_EQ(image.color[i], 0x12345678u);
    ++misses;
  }
  EXPECT_GT(misses, 0);
}

TEST(Refinement, ValuesThatAreNotFiniteDoNotCount) {
  Image image;
  image.resize(2, 1, 1, Image::kWide);
  image.depth = {0.5f, 0.5f};
  image.wideColor = {0.25f, 0.5f, 1, 1, 3, 0, 0, 1};
  Refinement refinement;
  refinement.add(image);
  const std::vector<float> kept = image.wideColor;
  image.wideColor[0] = std::nanf(""), image.wideColor[4] = HUGE_VALF;
  refinement.add(image);
  Image out;
  refinement.show(image, true, out);
  EXPECT_EQ(out.wideColor, kept);
  EXPECT_EQ(refinement.noise(), 0) << "what is brighter than white looks alike";
}

TEST(Refinement, KnowsTheNoiseOfPixelsThatAreALittleBrighterThanWhite) {
  Image image;
  image.resize(3, 1, 1, Image::kWide);
  image.depth = {0.5f, 0.5f, 0.5f};
  image.wideColor = {1.1f, 1.1f, 1.1f, 1, 7, 7, 7, 1, 0.5f, 0.5f, 0.5f, 1};
  Refinement refinement;
  refinement.keepNoise();
  refinement.add(image);
  for (float& v : image.wideColor) v = v == 1 ? v : v + 0.2f;
  refinement.add(image);
  const std::vector<uint16_t>& noise = refinement.pixelNoise();
  ASSERT_EQ(noise.size(), 3u);
  EXPECT_EQ(noise[0], noise[2]);
  EXPECT_NEAR(noise[0] / double{render::kNoiseOne}, 0.1, 1e-3);
  EXPECT_EQ(noise[1], 0);
}

constexpr float kUneven = 0.005f;

/// Plates in the middle of a large wall, of which the rest has little noise.
scene::Snapshot unevenScene() {
  scene::Snapshot s = litScene(test::Hides::some, 256);
  s.settings.ao.radius = 1e-3f;  // of a diagonal of about 1400
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -14});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.noise = kUneven;
  return s;
}

/// An image of as many passes as its noise asks for.
struct Finished {
  Refinement refinement;
  Image image;
  explicit Finished(const scene::Snapshot& s) {
    test::CountingTrace tracer;
    scene::TraceCost cost;
    std::string error;
    Refiner refiner(s, refinement);
    while (!refiner.finished()) EXPECT_TRUE(refiner.pass(tracer.trace, 0, cost, error)) << error;
    refiner.show(image);
  }
};

TEST(Refinement, AdaptivePassesMeetTheSameNoiseWithFewerRays) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = unevenScene();
  const Finished adaptive(s);
  s.settings.refine.adaptive = false;
  const Finished all(s);
  const Image truth = reference(s, 4096);
  const double error = difference(adaptive.image, truth), without = difference(all.image, truth);
  EXPECT_LE(adaptive.refinement.noise(), kUneven);
  // The estimate is good to some percent.
  EXPECT_LT(error, 1.05 * kUneven) << without;
  EXPECT_LT(adaptive.refinement.tracedTiles(), 0.6 * static_cast<double>(all.refinement.tracedTiles()));
  RecordProperty("error", std::to_string(error) + " instead of " + std::to_string(without));
  RecordProperty("tiles", std::to_string(adaptive.refinement.tracedTiles()) + " instead of " +
                              std::to_string(all.refinement.tracedTiles()));
}

TEST(Refinement, AdaptivePassesDoNotDependOnThreadsOrInterruptions) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = unevenScene();
  const Finished whole(s);
  s.settings.threads = 3;
  test::CountingTrace tracer;
  Refinement refinement;
  Image image;
  // Each pass by a refiner of its own, as a program that draws the frame again and again.
  for (bool finished = false; !finished;) {
    Refiner refiner(s, refinement);
    scene::TraceCost cost;
    std::string error;
    ASSERT_TRUE(refiner.pass(tracer.trace, 0, cost, error)) << error;
    refiner.show(image);
    finished = refiner.finished();
  }
  EXPECT_EQ(refinement.passes(), whole.refinement.passes());
  EXPECT_EQ(image.color, whole.image.color);
  EXPECT_EQ(image.depth, whole.image.depth);
}

TEST(Refinement, IsTheSameForAnyNumberOfThreads) {
  scene::Snapshot s = litScene(test::Hides::some, 80);
  const Refined one(s, 3);
  s.settings.threads = 4;
  const Refined four(s, 3);
  EXPECT_EQ(one.image.color, four.image.color);
  EXPECT_EQ(one.refinement.noise(), four.refinement.noise());
}

}  // namespace
}  // namespace gluray::frame
