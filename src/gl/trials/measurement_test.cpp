#include "gl/trials/measurement.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

TEST(Measurement, KeepsTheFastestOfSomeTimes) {
  Measurement frames(3);
  EXPECT_FALSE(frames.isKnown());
  EXPECT_FALSE(frames.add(0.003));
  EXPECT_FALSE(frames.add(0.001));
  EXPECT_TRUE(frames.add(0.002));
  EXPECT_EQ(frames.seconds(), 0.001);
}

TEST(Measurement, CountsFailures) {
  Measurement frames(1);
  EXPECT_FALSE(frames.fails(2));
  EXPECT_TRUE(frames.fails(2));
  EXPECT_FALSE(frames.isKnown());
  EXPECT_TRUE(frames.add(0.004)) << "failures are no times";
}

}  // namespace
}  // namespace gluray::gl
