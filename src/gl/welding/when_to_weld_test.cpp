#include "gl/welding/when_to_weld.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

constexpr uint32_t kWorthWelding = WhenToWeld::kWorthWelding, kTooLarge = WhenToWeld::kTooLarge;

TEST(WhenToWeld, ATooLargeRunMakesLaterFramesWeldEarly) {
  WhenToWeld weld;
  EXPECT_EQ(weld.inList(), kWorthWelding);
  EXPECT_EQ(weld.inFrame(), kTooLarge);
  weld.sawRun(kTooLarge - 1);
  EXPECT_EQ(weld.inFrame(), kTooLarge);
  weld.sawRun(kTooLarge);
  EXPECT_EQ(weld.inFrame(), kWorthWelding);
}

TEST(WhenToWeld, RunsBelowKWorthWeldingChangeNothing) {
  WhenToWeld weld;
  weld.sawRun(kTooLarge);
  weld.sawRun(3);
  EXPECT_EQ(weld.inFrame(), kWorthWelding);
  weld.sawRun(kWorthWelding);
  EXPECT_EQ(weld.inFrame(), kTooLarge);
}

}  // namespace
}  // namespace gluray::gl
