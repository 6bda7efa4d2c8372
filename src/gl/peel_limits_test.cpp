#include "gl/peel_limits.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

constexpr uint64_t kPixels = 100'000;

/// So many pixels with `n` layers, with nothing opaque behind them.
LayerCounts open(size_t n, uint32_t pixels) {
  LayerCounts counts;
  counts.open[n] = pixels;
  return counts;
}

LayerCounts before(size_t n, uint32_t pixels) {
  LayerCounts counts;
  counts.before[n] = pixels;
  return counts;
}

TEST(PeelLimits, FarthestLayersThatPeelsWrite) {
  EXPECT_EQ(writtenBehind(open(1, 10), 1), 0u);
  EXPECT_EQ(writtenBehind(open(2, 10), 1), 10u);
  EXPECT_EQ(writtenBehind(open(3, 10), 2), 0u);
  EXPECT_EQ(writtenBehind(open(4, 10), 2), 10u);
  EXPECT_EQ(writtenBehind(before(5, 10), 1), 0u);
  EXPECT_EQ(writtenBehind(before(2, 10), 2), 0u);
  EXPECT_EQ(writtenBehind(before(3, 10), 2), 10u);
}

TEST(PeelLimits, OnePeelIsCertain) {
  EXPECT_TRUE(showsAll({}, open(2, 5000), kPixels));
  EXPECT_FALSE(showsAll({}, open(3, 5000), kPixels));
  EXPECT_FALSE(showsAll({}, before(2, 5000), kPixels));
  EXPECT_TRUE(showsAll({}, open(3, 100), kPixels));
}

TEST(PeelLimits, PeelsEndWhereTooLittleWasWritten) {
  const PeelLimits all{20, 32};
  EXPECT_TRUE(showsAll(all, open(12, 5000), kPixels));
  // Everything lies before something opaque: nothing is written behind, and the first peel is the last.
  EXPECT_FALSE(showsAll(all, before(2, 5000), kPixels));
  EXPECT_FALSE(showsAll({20, 6000}, open(4, 5000), kPixels));
  EXPECT_FALSE(showsAll({2, 32}, open(6, 5000), kPixels));
  LayerCounts both = before(2, 5000);
  both.open[2] = 100;
  EXPECT_TRUE(showsAll(all, both, kPixels));
}

TEST(PeelWatch, LearnsFromFramesThatTheProgramDraws) {
  PeelWatch watch;
  watch.begin();
  EXPECT_FALSE(watch.declined(open(4, 5000)));
  for (const GLuint texture : {7, 7, 8, 7}) watch.drawn(texture);
  EXPECT_EQ(watch.limits(), (PeelLimits{3, 5000}));
  EXPECT_TRUE(showsAll(watch.limits(), open(4, 5000), kPixels));
}

TEST(PeelWatch, SaysWhereNothingWasLearned) {
  PeelWatch watch;
  for (const bool again : {false, true, true}) {
    watch.begin();
    EXPECT_EQ(watch.declined(open(8, 5000)), again);
    watch.drawn(7);  // the program wants no more than one
  }
  EXPECT_FALSE(showsAll(watch.limits(), open(8, 5000), kPixels));
}

}  // namespace
}  // namespace gluray::gl
