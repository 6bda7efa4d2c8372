// Frames of animations against full ones.
#include "base/sanitized.h"
#include "render/testing/test_animation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

using test::Animation;
using test::boards;
using test::kMovingSize;
using test::Mode;
using test::turn;

/// dB over pixels that both show.
double psnr(const Image& a, const Image& b) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < a.color.size(); ++i) {
    if (b.depth[i] == Image::kMiss) continue;
    const double d = static_cast<double>(a.color[i] & 255) - static_cast<double>(b.color[i] & 255);
    sum += d * d, ++count;
  }
  EXPECT_GT(count, 1000);
  return 10 * std::log10(255.0 * 255 * count / std::max(sum, 1e-9));
}

double meanOf(const Image& image) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < image.color.size(); ++i)
    if (image.depth[i] != Image::kMiss) sum += image.color[i] & 255, ++count;
  return sum / count;
}

TEST(Moving, FirstFrameIsNearTheConvergedOne) {
  Animation animation;
  scene::Snapshot s = boards();
  turn(s, 0);
  const test::Traced truth = animation.converged(s), first = animation.frame(s);
  EXPECT_GT(psnr(first.image, truth.image), 29) << "one ray a pixel without a filter gives 15 dB";
  EXPECT_EQ(first.image.depth, truth.image.depth);
  EXPECT_NEAR(meanOf(first.image), meanOf(truth.image), 1);
}

TEST(Moving, FramesOfAnOrbitConverge) {
  GLURAY_RELEASE_ONLY();
  for (const bool quarter : {false, true}) {
    Animation animation;
    animation.rays.quarter = quarter;
    scene::Snapshot s = boards();
    turn(s, 0);
    test::Traced last;
    for (int i = 0; i <= 30; ++i) turn(s, i), last = animation.frame(s);
    const test::Traced truth = animation.converged(s);
    EXPECT_GT(psnr(last.image, truth.image), quarter ? 30.5 : 35);
    EXPECT_NEAR(meanOf(last.image), meanOf(truth.image), 0.6);
  }
}

TEST(Moving, StaticFramesConverge) {
  Animation animation;
  scene::Snapshot s = boards();
  turn(s, 10);
  const test::Traced truth = animation.converged(s);
  const double first = psnr(animation.frame(s).image, truth.image);
  test::Traced last;
  for (int i = 0; i < 32; ++i) last = animation.frame(s);
  EXPECT_GT(psnr(last.image, truth.image), first + 4);
}

TEST(Moving, IsTheSameForAnyNumberOfThreads) {
  Animation one, four;
  scene::Snapshot s = boards();
  for (int i = 0; i < 4; ++i) {
    turn(s, i);
    one.rays.quarter = four.rays.quarter = i > 1;
    s.settings.threads = 1;
    Arena single{1};
    one.world.update(s, single);
    s.lightSampling.mode = Mode::moving;
    test::Traced a;
    traceImage(s, one.world, single, a.image, {&one.histories, one.rays});
    EXPECT_EQ(a.image.color, four.frame(s).image.color) << i;
  }
}

TEST(Moving, AnythingButPlainImagesTakeAllSamples) {
  Animation animation;
  scene::Snapshot s = boards();
  turn(s, 0);
  s.settings.spp = 4;
  EXPECT_EQ(animation.frame(s).image.color, animation.frame(s, Mode::full).image.color);
  s.settings.spp = 1;
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.assign(kMovingSize * kMovingSize, -1.0f);
  s.layers = layers;
  EXPECT_EQ(animation.frame(s).image.color, animation.frame(s, Mode::full).image.color);
  EXPECT_EQ(animation.histories.bytes(), 0u);
}

TEST(Moving, IsTheLocalLookWithoutLight) {
  Animation animation;
  scene::Snapshot s = boards();
  turn(s, 0);
  s.settings.ao.enabled = false;
  const test::Traced before = animation.frame(s);
  EXPECT_EQ(animation.histories.bytes(), 0u);
  for (int i = 0; i < 3; ++i) {
    s.settings.ao.enabled = true;
    EXPECT_NE(animation.frame(s).image.color, before.image.color);
    s.settings.ao.enabled = false;
    EXPECT_EQ(animation.frame(s).image.color, before.image.color);
  }
}

TEST(Moving, FullFramesDoNotDependOnEarlierOnes) {
  Animation animation, fresh;
  scene::Snapshot s = boards();
  for (int i = 0; i < 3; ++i) turn(s, i), animation.frame(s);
  EXPECT_EQ(animation.frame(s, Mode::full).image.color, fresh.frame(s, Mode::full).image.color);
}

TEST(Moving, ScenesMayHaveAnySize) {
  GLURAY_RELEASE_ONLY();
  double expected = 0;
  for (const float size : {1.0f, 1e-6f, 1e6f, 1e-9f, 1e9f}) {
    Animation animation;
    scene::Snapshot s = boards(size);
    test::Traced last;
    for (int i = 0; i < 8; ++i) turn(s, i, static_cast<double>(size)), last = animation.frame(s);
    const double quality = psnr(last.image, animation.converged(s).image);
    if (size == 1) expected = quality;
    EXPECT_NEAR(quality, expected, 1) << size;
  }
}

TEST(Moving, AnyProjectionWillDo) {
  GLURAY_RELEASE_ONLY();
  const auto quality = [](const glm::dmat4& clipFromEye, bool reversed) {
    Animation animation;
    scene::Snapshot s = boards();
    test::Traced last;
    for (int i = 0; i < 8; ++i) {
      turn(s, i);
      s.camera.clipFromEye = clipFromEye;
      if (reversed)
        s.camera.depthNear = 1, s.camera.depthFar = 0, s.camera.clipFromEye[2] *= -1.0,
        s.camera.clipFromEye[3][2] *= -1.0;
      last = animation.frame(s);
    }
    return psnr(last.image, animation.converged(s).image);
  };
  const glm::dmat4 perspective = glm::perspective(glm::radians(35.0), 1.0, 0.5, 20.0),
                   parallel = glm::ortho(-1.6, 1.6, -1.6, 1.6, 0.5, 20.0),
                   mirror = glm::scale(glm::dmat4(1), {-1, 1, 1}),
                   aside = glm::frustum(-0.2, 0.1, -0.12, 0.18, 0.5, 20.0);
  const double expected = quality(perspective, false);
  EXPECT_GT(expected, 29);
  EXPECT_NEAR(quality(mirror * perspective, false), expected, 1.5);
  EXPECT_NEAR(quality(parallel, false), expected, 2.5);
  EXPECT_NEAR(quality(mirror * parallel, false), expected, 2.5);
  EXPECT_NEAR(quality(aside, false), expected, 2.5);
}

TEST(Moving, GhostsOfMovedObjectsFadeAtOnce) {
  // A lid just above the floor, out of sight of the camera, which looks along the floor's normal.
  scene::Snapshot s = test::makeSnapshot({test::parallelogram({0, 0, 0}, {50, 0, 0}, {0, 50, 0}),
                                          test::parallelogram({0, 0, 8}, {50, 0, 0}, {0, 50, 0})},
                                         kMovingSize);
  s.settings.ao.enabled = true, s.settings.ao.radius = 1;
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  const auto placeLid = [&](float up) {
    s.instances[1].worldFromObject[3] = {0, 0, up, 1};
    for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld * glm::dmat4(i.worldFromObject);
  };
  Animation animation;
  placeLid(0);
  for (int i = 0; i < 20; ++i) animation.frame(s);
  const double dark = meanOf(animation.frame(s).image);
  EXPECT_LT(dark, 40);
  placeLid(4000);
  test::Traced last;
  for (int i = 0; i < 6; ++i) placeLid(4000.0f + static_cast<float>(i)), last = animation.frame(s);
  EXPECT_NEAR(meanOf(last.image), meanOf(animation.converged(s).image), 5);
}

TEST(Moving, ChangedSettingsForgetEarlierFrames) {
  scene::Snapshot s = boards();
  turn(s, 0);
  Animation animation;
  for (int i = 0; i < 5; ++i) animation.frame(s);
  s.settings.ao.radius = 0.02f;
  EXPECT_NEAR(meanOf(animation.frame(s).image), meanOf(animation.converged(s).image), 1.5);
}

TEST(Moving, ImpostorsAndCulledSidesAreFoundAgain) {
  GLURAY_RELEASE_ONLY();
  auto spheres = std::make_shared<scene::Mesh>();
  spheres->shape = scene::Shape::spheres;
  spheres->vertexCount = spheres->triangleCount = 2;
  spheres->positions =
      test::makeAttribute<glm::vec3>({{-0.3f, 0, 0.3f}, {0.4f, 0.5f, 0.2f}}, scene::Format::float3);
  spheres->radius = 0.3f;
  spheres->lower = {-0.6f, -0.3f, -0.1f}, spheres->upper = {0.7f, 0.8f, 0.6f};
  Animation animation;
  scene::Snapshot s = test::makeSnapshot({test::parallelogram({0, 0, 0}, {3, 0, 0}, {0, 3, 0}), spheres,
                                          test::parallelogram({0, 0, 1.2f}, {3, 0, 0}, {0, 3, 0})},
                                         kMovingSize);
  s.settings.ao.enabled = true;
  s.instances[2].cull = scene::CullFace::both;
  for (int i = 0; i < 4; ++i) {
    turn(s, i);
    s.instances[1].lightingFromObject = glm::mat4(s.instances[1].eyeFromObject);
    const test::Traced moving = animation.frame(s);
    EXPECT_EQ(moving.image.depth, animation.frame(s, Mode::full).image.depth);
    EXPECT_NEAR(meanOf(moving.image), meanOf(animation.converged(s).image), 2);
  }
}

TEST(Moving, ViewsHaveHistoriesOfTheirOwn) {
  Animation animation;
  scene::Snapshot s = boards();
  turn(s, 0);
  for (uint64_t view = 0; view < 3 * LightHistories::kMax; ++view) s.view = view, animation.frame(s);
  const size_t bytes = animation.histories.bytes();
  EXPECT_LE(bytes, LightHistories::kMax * kMovingSize * kMovingSize * 64);
  EXPECT_GT(bytes, 0u);
}

}  // namespace
}  // namespace gluray::render
