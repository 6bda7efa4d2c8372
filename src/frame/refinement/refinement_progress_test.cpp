// What is told of an image that takes long, and limits of time.
#include "frame/refinement/refinement_progress.h"

#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gluray::frame {
namespace {

using test::CountingTrace, test::litScene, test::Refined;

Settings settingsFor(float noise, int passes, float seconds = 0) {
  Settings settings;
  settings.noise = noise, settings.refine.passes = passes, settings.refine.seconds = seconds;
  return settings;
}

/// Eight passes that have taken three seconds.
struct ThreeSeconds : Refined {
  ThreeSeconds() : Refined(litScene(), 8) { refinement.addTime(3 - refinement.seconds()); }
};

TEST(RefinementProgress, FollowsTheNoise) {
  const ThreeSeconds refined;
  const double noise = refined.refinement.noise();
  ASSERT_GT(noise, 0);
  const auto half = static_cast<float>(noise / 2);  // takes four times the passes
  const RefinementProgress progress = progressOf(refined.refinement, settingsFor(half, 1000));
  EXPECT_NEAR(progress.share, 0.25, 0.001);
  EXPECT_NEAR(progress.secondsLeft, 9, 0.05);
  EXPECT_EQ(progress.noise, noise);
}

TEST(RefinementProgress, EndsWithTheLastPassOrTheTime) {
  const ThreeSeconds refined;
  const RefinementProgress passes = progressOf(refined.refinement, settingsFor(1e-6f, 16));
  EXPECT_NEAR(passes.share, 0.5, 1e-6);
  EXPECT_NEAR(passes.secondsLeft, 3, 1e-6);
  const RefinementProgress time = progressOf(refined.refinement, settingsFor(1e-6f, 100000, 12));
  EXPECT_NEAR(time.share, 0.25, 1e-6);
  EXPECT_NEAR(time.secondsLeft, 9, 1e-5);
  EXPECT_EQ(progressOf(refined.refinement, settingsFor(1, 16)).share, 1);
  EXPECT_EQ(progressOf(refined.refinement, settingsFor(1, 16)).secondsLeft, 0);
}

/// A pass that fills the whole wait in parts: nothing is known of the others.
TEST(RefinementProgress, TellsNoTimeBeforeTheFirstPass) {
  Refined refined(litScene(), 0);
  refined.refinement.addTime(3);
  const RefinementProgress progress = progressOf(refined.refinement, settingsFor(0.01f, 16));
  EXPECT_EQ(progress.share, 0);
  EXPECT_TRUE(std::isinf(progress.secondsLeft));
  EXPECT_EQ(progressLine(progress, settingsFor(0.01f, 16)), "gluray: refining the image: 0 %, first pass");
  EXPECT_NEAR(progressOf(refined.refinement, settingsFor(0.01f, 16, 12)).secondsLeft, 9, 1e-5);
}

/// A program may wait again for an image that has passes already: the rest takes as long as these did for
/// each.
TEST(RefinementProgress, CountsTheTimeOfEarlierWaits) {
  ThreeSeconds refined;
  const Settings settings = settingsFor(1e-6f, 16);
  CountingTrace tracer;
  scene::Snapshot s = litScene();
  s.settings.noise = settings.noise, s.settings.refine.passes = settings.refine.passes;
  Refiner again(s, refined.refinement);
  scene::TraceCost cost;
  std::string error;
  ASSERT_TRUE(again.pass(tracer.trace, 0, cost, error)) << error;
  const RefinementProgress progress = progressOf(refined.refinement, settings);
  EXPECT_NEAR(progress.share, 9.0 / 16, 1e-6);
  EXPECT_NEAR(progress.secondsLeft, refined.refinement.seconds() * 7 / 9, 1e-6);
  EXPECT_GT(progress.secondsLeft, 2.3) << "not the time of the last pass alone";
}

TEST(RefinementProgress, IsOneLineOfText) {
  EXPECT_EQ(progressLine({0.437, 0.0214, 11.2}, settingsFor(0.01f, 1)),
            "gluray: refining the image: 43 %, noise 0.0214 of 0.0100, 12 s left");
  const double unknown = std::numeric_limits<double>::infinity();
  EXPECT_EQ(progressLine({0.01, unknown, 4000}, settingsFor(0.01f, 1)),
            "gluray: refining the image: 1 %, 1 h 6 min left");
  EXPECT_EQ(progressLine({0.01, unknown, 61}, settingsFor(0.01f, 1)),
            "gluray: refining the image: 1 %, 1 min left");
}

TEST(RefinementProgress, ShortImagesTellNothing) {
  const Settings settings = settingsFor(0.01f, 4);
  ProgressTeller teller(settings);
  teller.passed(Refined(litScene(), 2).refinement);
  EXPECT_FALSE(awaitedProgress());
}

TEST(Refiner, DividesManySamplesIntoPasses) {
  scene::Snapshot s = litScene(test::Hides::some, 32, 64);
  s.settings.shadows.samples = 5, s.settings.shadows.enabled = true;
  s.settings.refine.passes = 2;
  divideIntoPasses(s.settings);
  EXPECT_EQ(s.settings.ao.samples, 16);
  EXPECT_EQ(s.settings.shadows.samples, 2);
  EXPECT_EQ(s.settings.refine.passes, 8);
  const Settings once = s.settings;
  divideIntoPasses(s.settings);
  EXPECT_EQ(s.settings.ao.samples, once.ao.samples);
  EXPECT_EQ(s.settings.refine.passes, once.refine.passes);
  s.settings.shadows.enabled = false, s.settings.shadows.samples = 4096;
  divideIntoPasses(s.settings);
  EXPECT_EQ(s.settings.refine.passes, once.refine.passes) << "what is off counts for nothing";
}

TEST(Refiner, PassesOfManySamplesEqualOneImage) {
  scene::Snapshot s = litScene(test::Hides::some, 32, 64);
  s.wideColors = true;
  Refined refined(s, 4);
  EXPECT_LT(test::difference(refined.image, test::CountingTrace().image(s)), 1e-6);
}

TEST(Refiner, EndsInTime) {
  scene::Snapshot s = litScene();
  s.settings.noise = 1e-6f, s.settings.refine.passes = 1 << 24;
  Refinement refinement;
  Refiner refiner(s, refinement);
  test::CountingTrace tracer;
  scene::TraceCost cost;
  std::string error;
  ASSERT_TRUE(refiner.pass(tracer.trace, 0, cost, error));
  EXPECT_FALSE(refiner.finished());
  s.settings.refine.seconds = 1e-9f;
  EXPECT_TRUE(isFinished(refinement, s.settings)) << "one pass is all that it gets";
  s.settings.refine.seconds = 1e6f;
  EXPECT_FALSE(isFinished(refinement, s.settings));
  refinement.addTime(1e6);
  EXPECT_TRUE(isFinished(refinement, s.settings));
}

}  // namespace
}  // namespace gluray::frame
