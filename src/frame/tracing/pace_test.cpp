#include "frame/tracing/pace.h"

#include <gtest/gtest.h>

namespace gluray::frame {
namespace {

double raysOf(const Pace& pace) { return pace.rays().quarter ? 0.25 : pace.rays().perPixel; }

/// Frames whose time is the local look's and that of the rays.
void run(Pace& pace, int frames, double local, double perRay, double target) {
  for (int i = 0; i < frames; ++i) pace.took(local + perRay * raysOf(pace), target);
}

TEST(Pace, BeginsWithOneRayAPixel) { EXPECT_EQ(raysOf(Pace()), 1); }

TEST(Pace, TakesAsManyRaysAsThereIsTimeFor) {
  Pace pace;
  run(pace, 200, 0.010, 0.010, 0.066);
  EXPECT_EQ(raysOf(pace), 4) << "0.05 s; 8 rays would take 0.09 s";
}

TEST(Pace, FallsToAQuarterAndStaysThere) {
  Pace pace;
  run(pace, 100, 0.2, 0.2, 0.066);
  EXPECT_EQ(raysOf(pace), 0.25);
}

TEST(Pace, DoesNotSwing) {
  // Two rays are too slow, one is so fast that they seem to fit.
  Pace pace;
  int changes = 0;
  double last = 1;
  for (int i = 0; i < 1000; ++i) {
    pace.took(raysOf(pace) > 1 ? 0.1 : 0.03, 0.066);
    changes += raysOf(pace) != last, last = raysOf(pace);
  }
  EXPECT_LE(changes, 20);
  EXPECT_EQ(raysOf(pace), 1);
}

TEST(Pace, OneSlowFrameIsAnAccident) {
  Pace pace;
  run(pace, 3, 0.05, 0, 0.066);
  pace.took(0.1, 0.066);
  run(pace, 3, 0.05, 0, 0.066);
  EXPECT_EQ(raysOf(pace), 1);
}

TEST(Pace, IsTheSameForTheSameTimes) {
  Pace a, b;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.01 * (1 + i * 7 % 11);
    a.took(t, 0.066), b.took(t, 0.066);
    ASSERT_EQ(raysOf(a), raysOf(b));
  }
}

}  // namespace
}  // namespace gluray::frame
