#include "base/growing_interval.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

TEST(GrowingInterval, GrowsUpToTheLimit) {
  GrowingInterval<int> frames{64, 500};
  for (const int expected : {64, 128, 256, 500, 500}) EXPECT_EQ(frames.take(), expected);
  frames.restart();
  EXPECT_EQ(frames.take(), 64);
  EXPECT_EQ(frames.next, 128);
}

TEST(GrowingInterval, MayBeginWithoutWaiting) {
  GrowingInterval<double> seconds{2, 64, 4, 0};
  for (const double expected : {0, 2, 8, 32, 64}) EXPECT_EQ(seconds.take(), expected);
}

}  // namespace
}  // namespace gluray
