// What trials may cost in all: TrialLimit, and EngineChoice under it.
#include "gl/trials/trial_limit.h"

#include "gl/testing/fake_program.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::gl {
namespace {

using test::FakeProgram, test::Way, test::g_now;

TEST(TrialLimit, IsAShareOfTheFirstSecondsAndThenOfAllThatWasDrawn) {
  TrialLimit limit;
  EXPECT_TRUE(limit.affords(0.5));
  EXPECT_FALSE(limit.affords(0.51));
  limit.spend(0.4);
  EXPECT_FALSE(limit.affords(0.2));
  EXPECT_TRUE(limit.affords(-1)) << "what is faster costs nothing";
  limit.drew(10);
  EXPECT_FALSE(limit.affords(0.2)) << "the first seconds are those that were drawn";
  limit.drew(10);
  EXPECT_TRUE(limit.affords(0.2));
}

TEST(TrialLimit, IsNotChangedByTrialsThatGain) {
  TrialLimit limit;
  limit.spend(-3);
  EXPECT_FALSE(limit.affords(0.51));
}

/// Draws for `seconds`; returns the largest share of its time, and of the first ten seconds, that frames of
/// the way that takes `slow` instead of `fast` cost. The first frame, which is no trial, does not count.
double largestShare(FakeProgram& p, double slow, double fast, bool slowTraced, double seconds) {
  p.frame();
  const int before = slowTraced ? p.traceFrames : p.directFrames;
  double largest = 0;
  while (g_now < seconds) {
    p.frame();
    const double lost = ((slowTraced ? p.traceFrames : p.directFrames) - before) * (slow - fast);
    largest = std::max(largest, lost / std::max(g_now, TrialLimit::kFirstSeconds));
  }
  return largest;
}

/// 500,000 triangles above an OpenGL on the CPU are traced first.
TEST(TrialLimit, HoldsWhereTracedFramesTakeLong) {
  for (const double traced : {0.1, 0.3, 0.9, 2.0, 5.0})
    for (const double slower : {1.1, 1.5, 2.0}) {
      FakeProgram p;
      p.triangles = 500000, p.pixels = 1 << 20;
      p.traced = [=] { return traced; }, p.direct = [=] { return slower * traced; };
      EXPECT_LE(largestShare(p, slower * traced, traced, false, 600 * traced), TrialLimit::kShare)
          << traced << " s, " << slower;
      EXPECT_EQ(p.choice.way(), Way::traced);
    }
}

TEST(TrialLimit, HoldsWhereTheFramesOfTheRealOpenGlTakeLong) {
  for (const double direct : {0.01, 0.1, 0.9, 2.0, 5.0})
    for (const double slower : {1.1, 1.5, 2.0}) {
      FakeProgram p;
      p.triangles = 150000, p.pixels = 1 << 20;
      p.direct = [=] { return direct; }, p.traced = [=] { return slower * direct; };
      EXPECT_LE(largestShare(p, slower * direct, direct, true, 600 * direct), TrialLimit::kShare)
          << direct << " s, " << slower;
      EXPECT_EQ(p.choice.way(), Way::passthrough);
    }
}

TEST(TrialLimit, FramesOfASecondAreTriedLate) {
  FakeProgram p;
  p.triangles = 500000, p.pixels = 1 << 20;
  p.traced = [] { return 0.9; }, p.direct = [] { return 1.3; };
  p.frames(16);
  EXPECT_EQ(p.directFrames, 1) << "the first one, before anything was known";
  while (g_now < 120) p.frame();
  EXPECT_GE(p.directFrames, 2) << "they are tried, though";
}

TEST(TrialLimit, AFasterWayIsFoundWhereFramesTakeLong) {
  FakeProgram p;
  p.triangles = 500000, p.pixels = 1 << 20;
  p.traced = [] { return 0.9; }, p.direct = [] { return 0.4; };
  while (g_now < 60) p.frame();
  EXPECT_EQ(p.choice.way(), Way::passthrough);
}

TEST(TrialLimit, ATrialBeyondItEndsWithItsFirstFrame) {
  // The first traced frame takes far longer than twice as long, which nobody knows before.
  FakeProgram p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.4; }, p.traced = [] { return 8.0; };
  while (g_now < 150) p.frame();
  EXPECT_EQ(p.traceFrames, 1);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
}

TEST(TrialLimit, AFirstFrameThatTookLongDoesNotPreventTheNextTrial) {
  FakeProgram p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.4; }, p.traced = [&] { return p.traceFrames == 0 ? 2.0 : 0.1; };
  while (g_now < 1000) p.frame();
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(TrialLimit, HoldsForFramesThatAreNotMeasured) {
  // Most frames are small ones, which measurements leave out.
  FakeProgram p;
  int frame = 0;
  const auto isLarge = [&] { return frame % 30 == 0; };
  p.direct = [] { return 0.5; }, p.traced = [] { return 0.9; };
  for (; g_now < 300; ++frame) {
    p.triangles = isLarge() ? 150000 : 500, p.pixels = isLarge() ? 1 << 20 : 1 << 14;
    p.frame();
    EXPECT_LE(0.4 * p.traceFrames, TrialLimit::kShare * std::max(g_now, TrialLimit::kFirstSeconds));
  }
  EXPECT_GE(p.traceFrames, 1);
}

}  // namespace
}  // namespace gluray::gl
