#include "gl/objects/shown_frames.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

ShownFramePtr frameOf(uint64_t frame, size_t batches, double age = 0) {
  ShownFrame shown;
  shown.frame = frame, shown.batches.resize(batches), shown.when = nowSeconds() - age;
  return std::make_shared<const ShownFrame>(shown);
}

struct ShownFramesTest : testing::Test {
  ShownFramesTest() { frames.wantUntil(nowSeconds() + 60); }
  ShownFrames frames;
  const int one = 1, two = 2;
};

TEST_F(ShownFramesTest, NothingIsKeptUnasked) {
  EXPECT_TRUE(frames.wanted());
  frames.show(&one, frameOf(3, 1));
  frames.wantUntil(0);
  EXPECT_FALSE(frames.wanted());
  EXPECT_EQ(frames.last(), nullptr);
  frames.show(&one, frameOf(4, 1));
  EXPECT_EQ(frames.last(), nullptr);
}

TEST_F(ShownFramesTest, TheLastIsThatOfTheContextThatTraces) {
  const ShownFramePtr traced = frameOf(1, 2), other = frameOf(2, 1);
  frames.show(&one, traced);
  frames.show(&two, frameOf(2, 0));
  EXPECT_EQ(frames.last(), traced);
  frames.show(&two, other);
  EXPECT_EQ(frames.last(), other);
  EXPECT_EQ(frames.all(), (std::vector<ShownFramePtr>{traced, other}));
  frames.forget(&two);
  EXPECT_EQ(frames.last(), traced);
}

TEST_F(ShownFramesTest, FramesThatGrowAreNotShownUntilTheyAreWhole) {
  const ShownFramePtr first = frameOf(0, 3, 1), part = frameOf(0, 1), later = frameOf(0, 1, 1);
  frames.show(&one, first);
  frames.whole(&one);
  frames.show(&one, part);
  EXPECT_EQ(frames.last(), first);
  frames.show(&two, frameOf(7, 0));
  EXPECT_EQ(frames.last(), part) << "another context has swapped";
  frames.whole(&one);
  frames.show(&one, later);
  EXPECT_EQ(frames.last(), later) << "nothing has come for a while";
}

}  // namespace
}  // namespace gluray::gl
