// Images smoothed: nearer to converged ones, and to the bit where nothing is noisy.
#include "frame/refinement/denoiser.h"

#include "base/sanitized.h"
#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::frame {
namespace {

using test::difference, test::litScene, test::Refined;

scene::Snapshot smoothed(scene::Snapshot s) {
  s.settings.denoise = Denoise::filter;
  return s;
}

double dB(const Image& a, const Image& b) { return -20 * std::log10(difference(a, b)); }

/// The same surfaces, lit by the sky and each other.
scene::Snapshot pathScene(int size) {
  scene::Snapshot s = litScene(test::Hides::some, size, 1);
  s.settings.ao.enabled = false;
  s.settings.integrator = LightIntegrator::path;
  s.settings.path.samples = 2;
  s.shadings[0].lighting = true;
  for (size_t i = 0; i < s.instances.size(); ++i) {
    scene::MaterialPair& pair = s.instances[i].materials[0];
    pair.front.diffuse = i % 2 ? glm::vec4(0.9f, 0.3f, 0.2f, 1) : glm::vec4(0.7f, 0.7f, 0.8f, 1);
    pair.back = pair.front;
  }
  s.settings.environment.strength = 1;
  return s;
}

scene::Snapshot many(scene::Snapshot s) {
  s.settings.ao.samples = s.settings.path.samples = 2048;
  return s;
}

TEST(Denoiser, BringsFewPassesNearerToTheConvergedImage) {
  GLURAY_RELEASE_ONLY();
  for (const bool paths : {false, true}) {
    scene::Snapshot s = paths ? pathScene(96) : litScene(test::Hides::some, 96);
    const Image truth = test::CountingTrace().image(many(s));
    for (const int passes : {1, 4, 16}) {
      const double plain = dB(Refined(s, passes).image, truth),
                   filtered = dB(Refined(smoothed(s), passes).image, truth);
      RecordProperty((paths ? "path" : "ao") + std::to_string(passes), std::to_string(filtered - plain));
      EXPECT_GT(filtered, plain + 4) << paths << ' ' << passes << ": " << plain;
    }
  }
}

TEST(Denoiser, KeepsEdgesOfShadowsUnderNoiseOfPaths) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = pathScene(72);
  scene::Light sun;
  sun.position = {0.5f, 0.8f, 1, 0}, sun.diffuse = glm::vec4(0.6f);
  s.shadings[0].lights = {sun};
  s.settings.environment.strength = 0.5f;
  for (const bool averages : {false, true}) {
    s.settings.spp = averages ? 4 : 1, s.settings.exposure = averages ? -0.5f : 0.0f;
    const Image truth = test::CountingTrace().image(many(s));
    const double plain = dB(Refined(s, 1).image, truth), filtered = dB(Refined(smoothed(s), 1).image, truth);
    EXPECT_GT(filtered, plain + 9) << plain << ' ' << averages;
  }
}

TEST(Denoiser, KeepsEdgesOfHardShadowsUnderNoiseOfOcclusion) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = litScene(test::Hides::some, 96, 2);
  scene::Light sun;
  sun.position = {0.5f, 0.8f, 1, 0}, sun.diffuse = glm::vec4(0.8f);
  s.shadings[0].lighting = true;
  s.shadings[0].lights = {sun};
  s.settings.shadows.enabled = true, s.settings.shadows.size = 0;
  const Image truth = test::CountingTrace().image(many(s));
  const double plain = dB(Refined(s, 1).image, truth), filtered = dB(Refined(smoothed(s), 1).image, truth);
  EXPECT_GT(filtered, plain + 9) << plain;
}

TEST(Denoiser, KeepsTheBitsOfFinishedPixels) {
  scene::Snapshot s = litScene(test::Hides::half);
  s.settings.noise = 0.2f;  // more than any pixel has
  EXPECT_EQ(Refined(smoothed(s), 8).image.color, Refined(s, 8).image.color);
}

TEST(Denoiser, KeepsDepthAlphaAndMisses) {
  scene::Snapshot s = litScene();
  s.instances.erase(s.instances.begin());
  for (scene::Instance& i : s.instances) i.color.a = 0.7f;
  const Image plain = Refined(s, 4).image, filtered = Refined(smoothed(s), 4).image;
  EXPECT_EQ(plain.depth, filtered.depth);
  int changed = 0;
  for (size_t i = 0; i < plain.color.size(); ++i) {
    EXPECT_EQ(plain.color[i] >> 24, filtered.color[i] >> 24);
    if (plain.depth[i] == Image::kMiss) { EXPECT_EQ(plain.color[i], filtered.color[i]); }
    changed += plain.color[i] != filtered.color[i];
  }
  EXPECT_GT(changed, 10);
}

TEST(Denoiser, IsTheSameForAnyNumberOfThreads) {
  scene::Snapshot s = smoothed(litScene(test::Hides::some, 150));
  const Refined one(s, 3);
  s.settings.threads = 4;
  EXPECT_EQ(one.image.color, Refined(s, 3).image.color);
}

TEST(Denoiser, SmoothsEachSampleOfMultisampledFramebuffers) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = litScene(test::Hides::some, 64);
  s.samples = 4;
  s.samplePositions = {{0.4f, 0.1f}, {0.9f, 0.4f}, {0.1f, 0.6f}, {0.6f, 0.9f}};
  s.settings.shading = ShadingRate::sample;
  const Image truth = test::CountingTrace().image(many(s));
  EXPECT_GT(dB(Refined(smoothed(s), 4).image, truth), dB(Refined(s, 4).image, truth) + 3);
}

TEST(Denoiser, ScenesMayHaveAnySize) {
  GLURAY_RELEASE_ONLY();
  double expected = 0;
  for (const float size : {1.0f, 1e-15f, 1e15f}) {
    scene::Snapshot s = smoothed(litScene(test::Hides::some, 64));
    s.eyeFromWorld = glm::scale(glm::dmat4(1), glm::dvec3(size)) * s.eyeFromWorld;
    s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1 * size, 1000.0 * size);
    for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld;
    const double quality = dB(Refined(s, 4).image, test::CountingTrace().image(many(s)));
    if (size == 1) expected = quality;
    EXPECT_NEAR(quality, expected, 1) << size;
  }
}

TEST(Denoiser, TheLibraryOrElseTheFilterSmooths) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = litScene(test::Hides::some, 96);
  const Image truth = test::CountingTrace().image(many(s));
  const double plain = dB(Refined(s, 4).image, truth);
  s.settings.denoise = Denoise::oidn;
  EXPECT_GT(dB(Refined(s, 4).image, truth), plain + 4);
}

TEST(Denoiser, TakesNoMemoryWhileOff) {
  const Refined off(litScene(), 3), on(smoothed(litScene()), 3);
  const size_t pixels = off.image.depth.size();
  EXPECT_EQ(off.refinement.bytes(), pixels * 28);
  EXPECT_EQ(on.refinement.bytes(), pixels * 44);
  EXPECT_LE(Refinement::bytesFor(pixels, AuxiliaryFeatures::kBytes), 64 * pixels);
}

TEST(Denoiser, ImagesStayUnfilteredWhereFeaturesFail) {
  const scene::Snapshot s = smoothed(litScene());
  test::CountingTrace tracer;
  tracer.failAt = 2;
  Refinement refinement;
  Refiner refiner(s, refinement);
  scene::TraceCost cost;
  std::string error;
  Image image;
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(refiner.pass(tracer.trace, 0, cost, error)) << error;
  refiner.show(image);
  EXPECT_EQ(image.color, Refined(litScene(), 4).image.color);
}

}  // namespace
}  // namespace gluray::frame
