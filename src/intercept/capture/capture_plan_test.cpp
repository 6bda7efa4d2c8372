// Plans of captures.
#include "intercept/capture/capture_plan.h"

#include <gtest/gtest.h>

namespace gluray::intercept {
namespace {

using When = CapturePlan::When;

TEST(CapturePlan, ReadsWhatTheLauncherWrites) {
  const auto every = readCapturePlan("every:10 /tmp/a folder");
  ASSERT_TRUE(every);
  EXPECT_EQ(every->folder, "/tmp/a folder");
  EXPECT_EQ(every->number, 10u);
  EXPECT_EQ(readCapturePlan("frame:3 /x")->when, When::frame);
  EXPECT_EQ(readCapturePlan("seconds:2.5 /x")->seconds, 2.5);
  EXPECT_EQ(readCapturePlan("idle /x")->when, When::idle);
  for (const char* wrong : {"", "idle", "idle x", "idle:3 /x", "frame:0 /x", "frame: /x", "frame:1x /x",
                            "seconds:-1 /x", "every /x", "later:2 /x", "seconds:nan /x"})
    EXPECT_FALSE(readCapturePlan(wrong)) << wrong;
}

TEST(CapturePlan, WantsItsFrames) {
  const CapturePlan third = *readCapturePlan("frame:3 /x"), every = *readCapturePlan("every:2 /x"),
                    later = *readCapturePlan("seconds:1.5 /x"), idle = *readCapturePlan("idle /x");
  for (uint64_t frame = 1; frame < 8; ++frame) {
    EXPECT_EQ(third.wants(frame, 9), frame == 3);
    EXPECT_EQ(every.wants(frame, 9), frame % 2 == 0);
    EXPECT_FALSE(idle.wants(frame, 9));
  }
  EXPECT_FALSE(later.wants(1, 1.4));
  EXPECT_TRUE(later.wants(1, 1.5));
  EXPECT_TRUE(later.keepsLast() && idle.keepsLast());
  EXPECT_FALSE(third.keepsLast() || every.keepsLast());
  EXPECT_FALSE(every.isSingle());
}

}  // namespace
}  // namespace gluray::intercept
