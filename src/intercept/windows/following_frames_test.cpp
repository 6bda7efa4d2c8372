#include "intercept/windows/following_frames.h"

#include <gtest/gtest.h>

namespace gluray::intercept {
namespace {

/// Adds a frame that starts `gap` seconds after the last swap and takes 0.01 seconds.
bool after(FollowingFrames& frames, double& now, double gap) {
  const bool follow = frames.complete(now + gap);
  frames.swapped(now += gap + 0.01);
  return follow;
}

TEST(FollowingFrames, ThreeInARow) {
  FollowingFrames frames;
  double now = 5;
  EXPECT_FALSE(after(frames, now, 0.02));  // the first frame
  EXPECT_FALSE(after(frames, now, 0.02));
  EXPECT_FALSE(after(frames, now, 0.02));
  EXPECT_TRUE(after(frames, now, 0.02));
  EXPECT_TRUE(after(frames, now, 0.09));
}

TEST(FollowingFrames, APauseResetsTheCount) {
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
