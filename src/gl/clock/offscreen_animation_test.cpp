#include "gl/clock/offscreen_animation.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

constexpr glm::ivec2 kLarge{803, 601}, kReduced{401, 300};

/// A frame of one batch that takes a tenth of a second, starting at `begin`.
bool animates(OffscreenAnimation& frames, uint64_t frame, double begin, glm::ivec2 size = kLarge) {
  const bool animated = frames.isAnimated(size, frame, begin);
  frames.drawn(begin + 0.1);
  return animated;
}

TEST(OffscreenAnimation, FramesThatFollowEachOther) {
  OffscreenAnimation frames;
  EXPECT_FALSE(animates(frames, 1, 100));
  EXPECT_TRUE(animates(frames, 2, 100.3));
  EXPECT_TRUE(animates(frames, 3, 100.6));
  EXPECT_FALSE(animates(frames, 4, 101.5)) << "after a pause";
}

TEST(OffscreenAnimation, ImagesThatTakeLongAreNoPause) {
  OffscreenAnimation frames;
  EXPECT_FALSE(frames.isAnimated(kLarge, 1, 100));
  frames.drawn(107);
  EXPECT_TRUE(frames.isAnimated(kLarge, 2, 107.2));
}

TEST(OffscreenAnimation, BatchesOfOneFrameAreAlike) {
  OffscreenAnimation frames;
  EXPECT_FALSE(animates(frames, 1, 100));
  EXPECT_FALSE(animates(frames, 1, 100.2));
  EXPECT_TRUE(animates(frames, 2, 100.4));
  EXPECT_TRUE(animates(frames, 2, 105)) << "the program has paused within a frame";
}

TEST(OffscreenAnimation, ReducedImagesAreAnimated) {
  OffscreenAnimation frames;
  EXPECT_FALSE(animates(frames, 1, 100));
  EXPECT_TRUE(animates(frames, 2, 200, kReduced));
  EXPECT_TRUE(animates(frames, 3, 200.2, kReduced));
  EXPECT_FALSE(animates(frames, 4, 200.4)) << "the first large one after a pause of its own";
  EXPECT_FALSE(animates(frames, 5, 300));
  EXPECT_TRUE(animates(frames, 6, 400, kReduced));
}

TEST(OffscreenAnimation, OtherShapesAreNotReduced) {
  OffscreenAnimation frames;
  EXPECT_FALSE(animates(frames, 1, 100));
  EXPECT_FALSE(animates(frames, 2, 100.2, {300, 300}));
  EXPECT_FALSE(animates(frames, 3, 100.4, {1606, 1202})) << "a larger one";
}

TEST(OffscreenAnimation, ForgetsSizesThatAreGone) {
  OffscreenAnimation frames;
  for (int i = 0; i < 1000; ++i) {
    const glm::ivec2 size{i % 100 * 7 + 1, i % 100 * i % 13 + 1};
    animates(frames, static_cast<uint64_t>(i), i);
    animates(frames, static_cast<uint64_t>(i), i, size);
  }
  EXPECT_TRUE(animates(frames, 2000, 999.5)) << "the last one was there at 999.1";
}

}  // namespace
}  // namespace gluray::gl
