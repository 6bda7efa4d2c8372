#include "intercept/windows/following_frames.h"

#include <gtest/gtest.h>

namespace gluray::intercept {
namespace {

/// Frames that are first seen `gap` seconds after the swap before, and take a hundredth.
bool after(FollowingFrames& frames, double& now, double gap) {
  const bool follow = frames.complete(now + gap);
  frames.swapped(now += gap + 0.01);
  return follow;
}

TEST(FollowingFrames, ThreeInARow) {
  FollowingFrames frames;
  double now = 5;
  EXPECT_FALSE(after(frames, now, 0.02));  // nothing was shown before
  EXPECT_FALSE(after(frames, now, 0.02));
  EXPECT_FALSE(after(frames, now, 0.02));
  EXPECT_TRUE(after(frames, now, 0.02));
  EXPECT_TRUE(after(frames, now, 0.09));
}

TEST(FollowingFrames, APauseEndsThem) {
  FollowingFrames frames;
  double now = 5;
  for (int i = 0; i < 5; ++i) after(frames, now, 0.01);
  EXPECT_FALSE(after(frames, now, 0.2));
  EXPECT_FALSE(after(frames, now, 0.01));
  EXPECT_FALSE(after(frames, now, 0.01));
  EXPECT_TRUE(after(frames, now, 0.01));
}

}  // namespace
}  // namespace gluray::intercept
