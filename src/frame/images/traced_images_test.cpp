// When images with light get more passes.
#include "frame/images/traced_images.h"

#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gluray::frame {
namespace {

using scene::LightSampling;
using test::litScene;

struct ImagesTest : testing::Test {
  test::CountingTrace tracer;
  TracedImages images{Tracer{tracer.trace}};
  scene::Snapshot scene = litScene();
  ImagesTest() { scene.view = 7, scene.lightSampling.mode = LightSampling::Mode::moving; }
  TracedImages::Result ask(bool finished = false) { return images.imageOf(scene, {.finished = finished}); }
  /// Redraws become better, and end before the image is finished, however fast the machine is.
  void neverFinish() {
    scene.settings.noise = 1e-6f;
    scene.settings.refine.passes = 1 << 24;
    scene.settings.fps = 1000;
  }
  /// Passes for which the image is asked again until it is finished.
  int askUntilRefined() {
    int asked = 0;
    while (!ask().cached->refined && asked < 10000) ++asked;
    return asked;
  }
};

TEST_F(ImagesTest, AMovingImageIsOnePass) {
  const auto result = ask();
  ASSERT_TRUE(result.cached);
  EXPECT_EQ(tracer.traces, 1);
  EXPECT_EQ(result.cached->image.color, test::CountingTrace().image(scene).color);
  EXPECT_FALSE(result.cached->refined);
  EXPECT_FALSE(result.cached->refinement);
}

TEST_F(ImagesTest, WithoutRefinementTheSameFrameTakesAllSamplesOnce) {
  scene.settings.noise = 0;
  scene::Snapshot full = scene;
  full.lightSampling.mode = LightSampling::Mode::full;
  const std::vector<uint32_t> expected = test::CountingTrace().image(full).color;
  EXPECT_NE(ask().cached->image.color, expected);
  EXPECT_EQ(ask().cached->image.color, expected);
  EXPECT_TRUE(ask().repeated);
  EXPECT_EQ(tracer.traces, 2);
}

TEST_F(ImagesTest, TheSameFrameGetsBetterUntilItIsFinished) {
  scene::Snapshot many = scene;
  many.settings.ao.samples = 1024, many.lightSampling.mode = LightSampling::Mode::full;
  const Image truth = tracer.image(many);
  const ImageCache::CachedImage* const one = ask().cached;
  const Image first = one->image;
  const uint64_t id = one->id;
  askUntilRefined();
  const TracedImages::Result last = ask();
  EXPECT_LT(test::difference(last.cached->image, truth), 0.5 * test::difference(first, truth));
  EXPECT_LE(test::difference(last.cached->image, truth), 0.012);
  EXPECT_NE(last.cached->id, id) << "write-backs know images by their ids";
  EXPECT_FALSE(last.cached->refinement);
  EXPECT_TRUE(last.repeated);
  const int traces = tracer.traces;
  EXPECT_EQ(ask().cached->id, last.cached->id);
  EXPECT_EQ(tracer.traces, traces) << "a finished image repeats";
}

/// Surfaces of other processes may have moved.
TEST_F(ImagesTest, ImagesThatDependOnOtherProcessesAreNotRepeated) {
  bool alone = false;
  TracedImages shared{
      Tracer{.trace = tracer.trace, .standsAlone = [&](const scene::Snapshot&) { return alone; }}};
  scene.number = 1;
  shared.imageOf(scene, {.finished = true});
  const int traces = tracer.traces;
  EXPECT_TRUE(shared.knows(scene, {}));
  EXPECT_TRUE(shared.imageOf(scene, {.finished = true}).repeated);
  EXPECT_EQ(tracer.traces, traces);
  scene.number = 2;
  EXPECT_FALSE(shared.knows(scene, {}));
  EXPECT_FALSE(shared.imageOf(scene, {.finished = true}).repeated);
  EXPECT_EQ(tracer.traces, 2 * traces);
  alone = true;
  scene.number = 3;
  EXPECT_TRUE(shared.imageOf(scene, {.finished = true}).repeated);
}

/// Other processes may show what this one makes.
TEST_F(ImagesTest, EachNewImageIsToldOnceAfterAllPasses) {
  std::vector<std::pair<Image, bool>> told;
  TracedImages made{
      Tracer{.trace = tracer.trace, .shown = [&](const scene::Snapshot&, const Image& image, bool finished) {
               told.emplace_back(image, finished);
             }}};
  const TracedImages::Result first = made.imageOf(scene, {});
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].first.color, first.cached->image.color);
  EXPECT_FALSE(told[0].second);
  const TracedImages::Result finished = made.imageOf(scene, {.finished = true});
  EXPECT_GT(finished.passes, 1u);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[1].first.color, finished.cached->image.color);
  EXPECT_TRUE(told[1].second);
  EXPECT_TRUE(made.imageOf(scene, {}).repeated);
  EXPECT_EQ(told.size(), 2u);
}

/// Images that another process makes are shown as they come, without passes, auxiliary features or filters.
TEST_F(ImagesTest, ImagesOfAnotherProcessAreShownAsTheyCome) {
  int traces = 0;
  bool refined = false;
  TracedImages given{
      Tracer{.trace =
                 [&](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string&) {
                   EXPECT_EQ(s.lightSampling.mode, LightSampling::Mode::full);
                   image.resize(s.region.width, s.region.height, 1);
                   std::ranges::fill(image.color, static_cast<uint32_t>(++traces));
                   std::ranges::fill(image.depth, 0.5f);
                   cost.elsewhere = true, cost.refined = refined;
                   return true;
                 },
             .standsAlone = [](const scene::Snapshot&) { return false; },
             .shown = [](const scene::Snapshot&, const Image&, bool) { ADD_FAILURE(); }}};
  scene.settings.denoise = Denoise::filter;
  scene.lightSampling.mode = LightSampling::Mode::full;
  scene.number = 1;
  const auto color = [&] { return given.imageOf(scene, {.finished = true}).cached->image.color[0]; };
  EXPECT_EQ(color(), 1u);
  EXPECT_EQ(color(), 2u) << "it becomes better there";
  refined = true;
  EXPECT_EQ(color(), 3u);
  EXPECT_EQ(color(), 3u) << "it is finished";
  scene.number = 2;
  EXPECT_EQ(color(), 4u);
  scene.settings.noise = 0;  // no passes at all
  scene.number = 3;
  EXPECT_EQ(color(), 5u);
  EXPECT_EQ(traces, 5);
}

TEST_F(ImagesTest, AveragesHaveMissesOfNoColor) {
  scene.settings.spp = 4;
  scene.instances.erase(scene.instances.begin());  // the wall: misses instead
  const std::vector<uint32_t> expected = ask(true).cached->image.color;
  const int traces = tracer.traces;
  const ImageCache::CachedImage& red =
      *images.imageOf(scene, {.missColor = 0xff0000ff, .finished = true}).cached;
  EXPECT_EQ(red.image.missColor, 0xff0000ffu);
  EXPECT_EQ(red.image.color, expected);
  EXPECT_EQ(tracer.traces, traces);
}

/// Windows that show images themselves want misses in the colour that the window was cleared to;
/// write-backs do not care.
TEST_F(ImagesTest, MissesOfOneColorOrAnotherAreTheSameImage) {
  scene.settings.fps = 1000;                       // redraws have time for few passes
  scene.instances.erase(scene.instances.begin());  // the wall: misses instead
  TracedImages steady{Tracer{tracer.trace}};
  while (!steady.imageOf(scene, {}).cached->refined) {}
  const std::vector<uint32_t> expected = steady.imageOf(scene, {}).cached->image.color;
  const int traces = std::exchange(tracer.traces, 0);
  constexpr uint32_t kRed = 0xff0000ff, kBlue = 0xffff0000;
  for (bool refined = false, direct = true; !refined; direct = !direct) {
    const TracedImages::Wish wish = direct ? TracedImages::Wish{.missColor = kRed} : TracedImages::Wish{};
    const ImageCache::CachedImage& cached = *images.imageOf(scene, wish).cached;
    EXPECT_EQ(cached.image.missColor, kRed);
    refined = cached.refined;
    EXPECT_EQ(images.imageOf(scene, {.asShown = true}).cached, &cached);
  }
  EXPECT_EQ(tracer.traces, traces);
  const uint64_t id = images.imageOf(scene, {.missColor = kRed}).cached->id;
  const ImageCache::CachedImage& blue = *images.imageOf(scene, {.missColor = kBlue}).cached;
  EXPECT_NE(blue.id, id) << "write-backs know images by their ids";
  ASSERT_EQ(blue.image.color.size(), expected.size());
  size_t misses = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    const bool miss = blue.image.depth[i] == Image::kMiss;
    misses += miss;
    EXPECT_EQ(blue.image.color[i], miss ? kBlue : expected[i]);
  }
  EXPECT_GT(misses, 0u);
}

TEST_F(ImagesTest, AReadGetsTheFinishedImage) {
  const TracedImages::Result read = ask(true);
  ASSERT_TRUE(read.cached);
  EXPECT_TRUE(read.cached->refined);
  EXPECT_LE(read.noise, 0.01);
  EXPECT_EQ(static_cast<int>(read.passes), tracer.traces);
  EXPECT_GE(tracer.traces, 4);
}

TEST_F(ImagesTest, AReadAfterMotionFinishesTheImage) {
  ask();
  const Image after = ask(true).cached->image;
  TracedImages fresh{Tracer{tracer.trace}};
  EXPECT_EQ(after.color, fresh.imageOf(scene, {.finished = true}).cached->image.color)
      << "whatever came before";
}

TEST_F(ImagesTest, ImagesThatNobodyWatchesAreFinished) {
  scene.lightSampling.mode = LightSampling::Mode::full;
  const TracedImages::Result result = ask();
  EXPECT_TRUE(result.cached->refined);
  EXPECT_LE(result.noise, 0.01);
}

TEST_F(ImagesTest, WithoutANoiseLimitThereIsOnePass) {
  scene.settings.noise = 0;
  const TracedImages::Result result = ask(true);
  EXPECT_EQ(tracer.traces, 1);
  scene::Snapshot full = scene;
  full.lightSampling.mode = LightSampling::Mode::full;
  EXPECT_EQ(result.cached->image.color, test::CountingTrace().image(full).color);
  EXPECT_TRUE(ask(true).repeated);
  EXPECT_EQ(tracer.traces, 1);
}

TEST_F(ImagesTest, WithoutLightAImageRepeats) {
  scene.settings.ao.enabled = false;
  ask(true);
  EXPECT_TRUE(ask(true).repeated);
  EXPECT_EQ(tracer.traces, 1);
}

TEST_F(ImagesTest, ThereAreMostPasses) {
  scene.settings.noise = 1e-6f;
  scene.settings.refine.passes = 6;
  EXPECT_EQ(ask(true).passes, 6u);
  EXPECT_TRUE(ask(true).repeated);
}

TEST_F(ImagesTest, LightWithoutNoiseNeedsTheLeastPasses) {
  scene = litScene(test::Hides::nothing);
  EXPECT_EQ(ask(true).passes, kMinPasses);
}

TEST_F(ImagesTest, AnotherImageOfTheViewFreesThePasses) {
  neverFinish();
  ask();
  const ImageCache::CachedImage* first = ask().cached;
  EXPECT_TRUE(first->refinement);
  scene.eyeFromWorld[3][0] = scene.instances[0].eyeFromObject[3][0] = 0.1;
  ask();
  EXPECT_FALSE(first->refinement);
}

TEST_F(ImagesTest, WithoutLightNoPassesAreKept) {
  neverFinish();
  ask();
  const ImageCache::CachedImage* first = ask().cached;
  EXPECT_TRUE(first->refinement);
  scene.view = 8;
  scene.settings.ao.enabled = false;
  ask();
  EXPECT_FALSE(first->refinement);
}

TEST_F(ImagesTest, AFailingPassLeavesTheLastImage) {
  const Image first = ask().cached->image;
  tracer.failAt = 2;
  const TracedImages::Result result = ask(true);
  ASSERT_TRUE(result.cached);
  EXPECT_EQ(result.cached->image.color, first.color);
  EXPECT_TRUE(result.repeated);
  EXPECT_TRUE(ask(true).repeated) << "it is not tried again";
}

TEST_F(ImagesTest, AFailureAfterSomePassesLeavesTheirMean) {
  tracer.failAt = 3;
  const TracedImages::Result result = ask(true);
  ASSERT_TRUE(result.cached);
  EXPECT_EQ(result.passes, 2u);
  scene.settings.ao.samples *= 2, scene.lightSampling.mode = LightSampling::Mode::full;
  EXPECT_LT(test::difference(result.cached->image, tracer.image(scene)), 0.003);
}

TEST_F(ImagesTest, IfNothingCanBeTracedThereIsNoImage) {
  TracedImages none{Tracer{[](const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error) {
    error = "never";
    return false;
  }}};
  EXPECT_FALSE(none.imageOf(scene, {.finished = true}).cached);
  EXPECT_EQ(none.imageOf(scene, {.finished = true}).why, "never");
}

}  // namespace
}  // namespace gluray::frame
