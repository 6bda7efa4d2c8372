// When to look at depths, and whether leaving out small draws pays.
#include "gl/culled/small/frame_trials.h"
#include "gl/culled/small/look_schedule.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using Way = FrameTrials::Way;

/// Draws frames that take so long each way; returns how many of them were culled.
int cull(FrameTrials& trials, int frames, double plain, double culled, double vertices = 1e6,
         double leftOut = 0.5) {
  int count = 0;
  double now = 0;
  for (int i = 0; i < frames; ++i) {
    const Way way = trials.next(false, {1000, vertices, leftOut * vertices});
    count += way == Way::culled;
    if (!trials.isMeasured()) continue;
    trials.start(now);
    EXPECT_TRUE(trials.wantsStop());
    trials.stop(now += way == Way::culled ? culled : plain);
    EXPECT_FALSE(trials.wantsStop());
  }
  return count;
}

TEST(FrameTrials, KeepWhatIsFaster) {
  FrameTrials pays, costs;
  EXPECT_GT(cull(pays, 1000, 0.1, 0.05), 990 - 10);
  EXPECT_TRUE(pays.pays());
  const int tried = cull(costs, 1000, 0.1, 0.099);
  EXPECT_FALSE(costs.pays());
  EXPECT_GT(tried, 10) << "some trials";
  EXPECT_LT(tried, 60) << "more and more rarely";
  EXPECT_LT(cull(costs, 4000, 0.1, 0.099), 60);
}

TEST(FrameTrials, FindThatItPaysLater) {
  FrameTrials trials;
  cull(trials, 300, 0.1, 0.2);
  EXPECT_FALSE(trials.pays());
  cull(trials, 600, 0.1, 0.05);
  EXPECT_TRUE(trials.pays());
  cull(trials, 3000, 0.1, 0.2);
  EXPECT_FALSE(trials.pays());
}

TEST(FrameTrials, LeaveFewOrLightDrawsAlone) {
  FrameTrials trials;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(trials.next(false, {20, 1e6}), Way::plain);
    EXPECT_FALSE(trials.isMeasured());
    EXPECT_EQ(trials.next(false, {1000, 1e4}), Way::plain);
    EXPECT_FALSE(trials.isMeasured());
  }
  EXPECT_EQ(trials.next(true, {1, 3}), Way::culled) << "always";
}

TEST(FrameTrials, GiveUpEarlyWhereNothingIsHidden) {
  FrameTrials trials;
  EXPECT_LT(cull(trials, 60, 0.1, 0.05, 1e6, 0.01), 6);
  EXPECT_FALSE(trials.pays());
}

TEST(FrameTrials, WaitForBoxes) {
  FrameTrials trials;
  int culled = 0;
  for (int i = 0; i < 20; ++i) {
    const Way way = trials.next(false, {1000, 1e6, 0, true});
    culled += way == Way::culled;
    if (!trials.isMeasured()) continue;
    EXPECT_EQ(way, Way::plain);
    trials.start(i), trials.stop(i + 0.1);
  }
  EXPECT_EQ(culled, 17) << "all after those that were measured plain";
  EXPECT_TRUE(trials.settles());
  EXPECT_GT(cull(trials, 100, 0.1, 0.05), 90);
  EXPECT_TRUE(trials.pays());
}

TEST(FrameTrials, MeasureScenesAnewThatHaveChanged) {
  FrameTrials trials;
  cull(trials, 100, 0.1, 0.05);
  EXPECT_TRUE(trials.pays());
  cull(trials, 100, 0.4, 0.5, 4e6);
  EXPECT_FALSE(trials.pays());
  // A scene that changes in each frame is not measured all the time.
  int culled = 0;
  for (int i = 0; i < 400; ++i) culled += cull(trials, 1, 0.4, 0.5, i % 2 ? 1e6 : 4e6);
  EXPECT_LT(culled, 120);
}

/// Vertices between the looks of a frame.
double spacing(LookSchedule& schedule, double wastedSeconds, int frames) {
  for (int frame = 0; frame < frames; ++frame) {
    schedule.beginFrame();
    for (int look = 0; look < 4; ++look) schedule.looked(wastedSeconds, 1e-3);
  }
  schedule.beginFrame();
  return schedule.due();
}

TEST(LookSchedule, LooksMoreOftenWhereDrawsWereMadeInVain) {
  LookSchedule wasteful, thrifty, balanced;
  const double start = balanced.due();
  EXPECT_LT(spacing(wasteful, 0.1, 10), start / 4);
  EXPECT_GT(spacing(thrifty, 0, 10), 4 * start);
  EXPECT_EQ(spacing(balanced, 1e-3, 10), start);
}

TEST(LookSchedule, IsDueAfterTheWorkOfThisLook) {
  LookSchedule schedule;
  schedule.beginFrame();
  EXPECT_FALSE(schedule.isDue());
  schedule.drew(schedule.due() - 1);
  EXPECT_FALSE(schedule.isDue());
  schedule.drew(1);
  EXPECT_TRUE(schedule.isDue());
  schedule.looked(0, 1e-3);
  EXPECT_FALSE(schedule.isDue());
  // The next look of the frame begins with the spacing that the one before has found.
  const double second = schedule.due();
  schedule.beginFrame();
  EXPECT_EQ(schedule.due(), second);
}

TEST(LookSchedule, TriesAgainWhereItHadStoppedLooking) {
  LookSchedule schedule;
  const double start = schedule.due();
  EXPECT_GT(spacing(schedule, 0, 60), 1000 * start);
  for (int frame = 0; frame < 130 && schedule.due() != start; ++frame) schedule.beginFrame();
  EXPECT_EQ(schedule.due(), start);
}

}  // namespace
}  // namespace gluray::gl
