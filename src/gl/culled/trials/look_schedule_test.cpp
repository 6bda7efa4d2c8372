// When depth reads are due.
#include "gl/culled/trials/look_schedule.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

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
  // The next look of the frame starts with the interval of the previous one.
  const double second = schedule.due();
  schedule.beginFrame();
  EXPECT_EQ(schedule.due(), second);
}

TEST(LookSchedule, BeginsWithEighthsOfTheFrameBefore) {
  LookSchedule schedule;
  schedule.beginFrame(true, 8e6);
  EXPECT_EQ(schedule.due(), 1e6);
  schedule.looked(0, 1e-3);
  schedule.beginFrame(true, 8e6);
  EXPECT_EQ(schedule.due(), 2e6) << "as it was found to pay";
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
