#include "control/link/rates.h"

#include <gtest/gtest.h>

namespace gluray::control {
namespace {

TEST(Rates, AreThoseOfTheLastSecond) {
  Rates rates;
  EXPECT_EQ(rates.framesPerSecond(), 0);
  EXPECT_FALSE(rates.traced());
  for (uint64_t i = 0; i <= 40; ++i) {
    const double now = 5 + 0.05 * static_cast<double>(i);
    rates.sample(100 + 2 * i, {2000 * i, 3 * i, i}, now);
  }
  EXPECT_NEAR(rates.framesPerSecond(), 40, 2);
  EXPECT_EQ(rates.triangles(), 1000u);
  EXPECT_NEAR(*rates.traced(), 0.75, 1e-9);
}

TEST(Rates, FallToZeroWhenNothingIsDrawn) {
  Rates rates;
  rates.sample(1, {0, 0, 0}, 0), rates.sample(11, {500, 10, 0}, 0.5);
  EXPECT_NEAR(rates.framesPerSecond(), 20, 1e-9);
  for (int i = 0; i < 12; ++i) rates.sample(11, {500, 10, 0}, 0.7 + 0.25 * i);
  EXPECT_EQ(rates.framesPerSecond(), 0);
  EXPECT_FALSE(rates.traced());
  EXPECT_EQ(rates.triangles(), 50u) << "of the last frames";
}

TEST(Rates, RareSamplesAreEnough) {
  Rates rates;
  rates.sample(1, {}, 0), rates.sample(101, {}, 10);
  EXPECT_NEAR(rates.framesPerSecond(), 10, 1e-9);
}

}  // namespace
}  // namespace gluray::control
