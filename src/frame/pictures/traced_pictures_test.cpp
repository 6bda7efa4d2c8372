// When pictures with light get more passes.
#include "frame/pictures/traced_pictures.h"

#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gluray::frame {
namespace {

using scene::LightSampling;
using test::litScene;

struct PicturesTest : testing::Test {
  test::CountingTrace tracer;
  TracedPictures pictures{Tracer{tracer.trace}};
  scene::Snapshot scene = litScene();
  PicturesTest() { scene.view = 7, scene.lightSampling.mode = LightSampling::Mode::moving; }
  TracedPictures::Result ask(bool finished = false) {
    return pictures.pictureOf(scene, {.finished = finished});
  }
  /// Redraws become better, and end before the picture is finished, however fast the machine is.
  void neverFinish() {
    scene.settings.noise = 1e-6f;
    scene.settings.refine.passes = 1 << 24;
    scene.settings.fps = 1000;
  }
  /// Passes for which the picture is asked again until it is finished.
  int askUntilRefined() {
    int asked = 0;
    while (!ask().picture->refined && asked < 10000) ++asked;
    return asked;
  }
};

TEST_F(PicturesTest, AMovingPictureIsOnePass) {
  const auto result = ask();
  ASSERT_TRUE(result.picture);
  EXPECT_EQ(tracer.traces, 1);
  EXPECT_EQ(result.picture->image.color, test::CountingTrace().picture(scene).color);
  EXPECT_FALSE(result.picture->refined);
  EXPECT_FALSE(result.picture->refinement);
}

TEST_F(PicturesTest, WithoutRefinementTheSameFrameTakesAllSamplesOnce) {
  scene.settings.noise = 0;
  scene::Snapshot full = scene;
  full.lightSampling.mode = LightSampling::Mode::full;
  const std::vector<uint32_t> expected = test::CountingTrace().picture(full).color;
  EXPECT_NE(ask().picture->image.color, expected);
  EXPECT_EQ(ask().picture->image.color, expected);
  EXPECT_TRUE(ask().repeated);
  EXPECT_EQ(tracer.traces, 2);
}

TEST_F(PicturesTest, TheSameFrameGetsBetterUntilItIsFinished) {
  scene::Snapshot many = scene;
  many.settings.ao.samples = 1024, many.lightSampling.mode = LightSampling::Mode::full;
  const Image truth = tracer.picture(many);
  const LastPictures::Picture* const one = ask().picture;
  const Image first = one->image;
  const uint64_t id = one->id;
  askUntilRefined();
  const TracedPictures::Result last = ask();
  EXPECT_LT(test::difference(last.picture->image, truth), 0.5 * test::difference(first, truth));
  EXPECT_LE(test::difference(last.picture->image, truth), 0.012);
  EXPECT_NE(last.picture->id, id) << "write-backs know pictures by their ids";
  EXPECT_FALSE(last.picture->refinement);
  EXPECT_TRUE(last.repeated);
  const int traces = tracer.traces;
  EXPECT_EQ(ask().picture->id, last.picture->id);
  EXPECT_EQ(tracer.traces, traces) << "a finished picture repeats";
}

/// Surfaces of other processes may have moved.
TEST_F(PicturesTest, PicturesThatDependOnOtherProcessesAreNotRepeated) {
  bool alone = false;
  TracedPictures shared{
      Tracer{.trace = tracer.trace, .standsAlone = [&](const scene::Snapshot&) { return alone; }}};
  scene.number = 1;
  shared.pictureOf(scene, {.finished = true});
  const int traces = tracer.traces;
  EXPECT_TRUE(shared.knows(scene, {}));
  EXPECT_TRUE(shared.pictureOf(scene, {.finished = true}).repeated);
  EXPECT_EQ(tracer.traces, traces);
  scene.number = 2;
  EXPECT_FALSE(shared.knows(scene, {}));
  EXPECT_FALSE(shared.pictureOf(scene, {.finished = true}).repeated);
  EXPECT_EQ(tracer.traces, 2 * traces);
  alone = true;
  scene.number = 3;
  EXPECT_TRUE(shared.pictureOf(scene, {.finished = true}).repeated);
}

/// Other processes may show what this one makes.
TEST_F(PicturesTest, EachNewPictureIsToldOnceAfterAllPasses) {
  std::vector<std::pair<Image, bool>> told;
  TracedPictures made{
      Tracer{.trace = tracer.trace, .shown = [&](const scene::Snapshot&, const Image& image, bool finished) {
               told.emplace_back(image, finished);
             }}};
  const TracedPictures::Result first = made.pictureOf(scene, {});
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].first.color, first.picture->image.color);
  EXPECT_FALSE(told[0].second);
  const TracedPictures::Result finished = made.pictureOf(scene, {.finished = true});
  EXPECT_GT(finished.passes, 1u);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[1].first.color, finished.picture->image.color);
  EXPECT_TRUE(told[1].second);
  EXPECT_TRUE(made.pictureOf(scene, {}).repeated);
  EXPECT_EQ(told.size(), 2u);
}

/// Pictures that another process makes are shown as they come, without passes, guides or filters.
TEST_F(PicturesTest, PicturesOfAnotherProcessAreShownAsTheyCome) {
  int traces = 0;
  bool refined = false;
  TracedPictures given{
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
  const auto color = [&] { return given.pictureOf(scene, {.finished = true}).picture->image.color[0]; };
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

TEST_F(PicturesTest, AveragesHaveMissesOfNoColor) {
  scene.settings.spp = 4;
  scene.instances.erase(scene.instances.begin());  // the wall: misses instead
  const std::vector<uint32_t> expected = ask(true).picture->image.color;
  const int traces = tracer.traces;
  const LastPictures::Picture& red =
      *pictures.pictureOf(scene, {.missColor = 0xff0000ff, .finished = true}).picture;
  EXPECT_EQ(red.image.missColor, 0xff0000ffu);
  EXPECT_EQ(red.image.color, expected);
  EXPECT_EQ(tracer.traces, traces);
}

/// Windows that show pictures themselves want misses in the colour that the window was cleared to;
/// write-backs do not care.
TEST_F(PicturesTest, MissesOfOneColorOrAnotherAreTheSamePicture) {
  scene.settings.fps = 1000;                       // redraws have time for few passes
  scene.instances.erase(scene.instances.begin());  // the wall: misses instead
  TracedPictures steady{Tracer{tracer.trace}};
  while (!steady.pictureOf(scene, {}).picture->refined) {}
  const std::vector<uint32_t> expected = steady.pictureOf(scene, {}).picture->image.color;
  const int traces = std::exchange(tracer.traces, 0);
  constexpr uint32_t kRed = 0xff0000ff, kBlue = 0xffff0000;
  for (bool refined = false, direct = true; !refined; direct = !direct) {
    const TracedPictures::Wish wish =
        direct ? TracedPictures::Wish{.missColor = kRed} : TracedPictures::Wish{};
    const LastPictures::Picture& picture = *pictures.pictureOf(scene, wish).picture;
    EXPECT_EQ(picture.image.missColor, kRed);
    refined = picture.refined;
    EXPECT_EQ(pictures.pictureOf(scene, {.asShown = true}).picture, &picture);
  }
  EXPECT_EQ(tracer.traces, traces);
  const uint64_t id = pictures.pictureOf(scene, {.missColor = kRed}).picture->id;
  const LastPictures::Picture& blue = *pictures.pictureOf(scene, {.missColor = kBlue}).picture;
  EXPECT_NE(blue.id, id) << "write-backs know pictures by their ids";
  ASSERT_EQ(blue.image.color.size(), expected.size());
  size_t misses = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    const bool miss = blue.image.depth[i] == Image::kMiss;
    misses += miss;
    EXPECT_EQ(blue.image.color[i], miss ? kBlue : expected[i]);
  }
  EXPECT_GT(misses, 0u);
}

TEST_F(PicturesTest, AReadGetsTheFinishedPicture) {
  const TracedPictures::Result read = ask(true);
  ASSERT_TRUE(read.picture);
  EXPECT_TRUE(read.picture->refined);
  EXPECT_LE(read.noise, 0.01);
  EXPECT_EQ(static_cast<int>(read.passes), tracer.traces);
  EXPECT_GE(tracer.traces, 4);
}

TEST_F(PicturesTest, AReadAfterMotionFinishesThePicture) {
  ask();
  const Image after = ask(true).picture->image;
  TracedPictures fresh{Tracer{tracer.trace}};
  EXPECT_EQ(after.color, fresh.pictureOf(scene, {.finished = true}).picture->image.color)
      << "whatever came before";
}

TEST_F(PicturesTest, PicturesThatNobodyWatchesAreFinished) {
  scene.lightSampling.mode = LightSampling::Mode::full;
  const TracedPictures::Result result = ask();
  EXPECT_TRUE(result.picture->refined);
  EXPECT_LE(result.noise, 0.01);
}

TEST_F(PicturesTest, WithoutANoiseLimitThereIsOnePass) {
  scene.settings.noise = 0;
  const TracedPictures::Result result = ask(true);
  EXPECT_EQ(tracer.traces, 1);
  scene::Snapshot full = scene;
  full.lightSampling.mode = LightSampling::Mode::full;
  EXPECT_EQ(result.picture->image.color, test::CountingTrace().picture(full).color);
  EXPECT_TRUE(ask(true).repeated);
  EXPECT_EQ(tracer.traces, 1);
}

TEST_F(PicturesTest, WithoutLightAPictureRepeats) {
  scene.settings.ao.enabled = false;
  ask(true);
  EXPECT_TRUE(ask(true).repeated);
  EXPECT_EQ(tracer.traces, 1);
}

TEST_F(PicturesTest, ThereAreMostPasses) {
  scene.settings.noise = 1e-6f;
  scene.settings.refine.passes = 6;
  EXPECT_EQ(ask(true).passes, 6u);
  EXPECT_TRUE(ask(true).repeated);
}

TEST_F(PicturesTest, LightWithoutNoiseNeedsTheLeastPasses) {
  scene = litScene(test::Hides::nothing);
  EXPECT_EQ(ask(true).passes, kMinPasses);
}

TEST_F(PicturesTest, AnotherPictureOfTheViewFreesThePasses) {
  neverFinish();
  ask();
  const LastPictures::Picture* first = ask().picture;
  EXPECT_TRUE(first->refinement);
  scene.eyeFromWorld[3][0] = scene.instances[0].eyeFromObject[3][0] = 0.1;
  ask();
  EXPECT_FALSE(first->refinement);
}

TEST_F(PicturesTest, WithoutLightNoPassesAreKept) {
  neverFinish();
  ask();
  const LastPictures::Picture* first = ask().picture;
  EXPECT_TRUE(first->refinement);
  scene.view = 8;
  scene.settings.ao.enabled = false;
  ask();
  EXPECT_FALSE(first->refinement);
}

TEST_F(PicturesTest, AFailingPassLeavesTheLastPicture) {
  const Image first = ask().picture->image;
  tracer.failAt = 2;
  const TracedPictures::Result result = ask(true);
  ASSERT_TRUE(result.picture);
  EXPECT_EQ(result.picture->image.color, first.color);
  EXPECT_TRUE(result.repeated);
  EXPECT_TRUE(ask(true).repeated) << "it is not tried again";
}

TEST_F(PicturesTest, AFailureAfterSomePassesLeavesTheirMean) {
  tracer.failAt = 3;
  const TracedPictures::Result result = ask(true);
  ASSERT_TRUE(result.picture);
  EXPECT_EQ(result.passes, 2u);
  scene.settings.ao.samples *= 2, scene.lightSampling.mode = LightSampling::Mode::full;
  EXPECT_LT(test::difference(result.picture->image, tracer.picture(scene)), 0.003);
}

TEST_F(PicturesTest, IfNothingCanBeTracedThereIsNoPicture) {
  TracedPictures none{Tracer{[](const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error) {
    error = "never";
    return false;
  }}};
  EXPECT_FALSE(none.pictureOf(scene, {.finished = true}).picture);
  EXPECT_EQ(none.pictureOf(scene, {.finished = true}).why, "never");
}

}  // namespace
}  // namespace gluray::frame
