#include "accel/memory/huge_pages.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>

namespace gluray::accel {
namespace {

int disabled() { return prctl(PR_GET_THP_DISABLE, 0, 0, 0, 0); }

TEST(SmallPages, RecognisesBalloonsThatReportFreePages) {
  EXPECT_TRUE(reportsFreePages("0x0005", "0110010100"));
  EXPECT_FALSE(reportsFreePages("0x0005", "0110000100"));
  EXPECT_FALSE(reportsFreePages("0x0002", "0110010100"));
  EXPECT_FALSE(reportsFreePages("0x0005", "01"));
  EXPECT_FALSE(reportsFreePages("", ""));
}

TEST(SmallPages, RestoresTheProcessSetting) {
  const int before = disabled();
  {
    const SmallPages none(1000);
    EXPECT_EQ(disabled(), before) << "small builds are not worth it";
  }
  { const SmallPages many(10'000'000); }
  EXPECT_EQ(disabled(), before);
  ASSERT_EQ(prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0), 0);
  {
    const SmallPages many(10'000'000);
    EXPECT_EQ(disabled(), 1);
  }
  EXPECT_EQ(disabled(), 1) << "a process that wants none stays without";
  prctl(PR_SET_THP_DISABLE, static_cast<unsigned long>(before), 0, 0, 0);
}

}  // namespace
}  // namespace gluray::accel
