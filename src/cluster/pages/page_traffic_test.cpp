#include "cluster/pages/page_traffic.h"

#include <gtest/gtest.h>

namespace gluray::cluster {
namespace {

constexpr size_t kMemory = 500'000'000, kPage = 100'000'000;

/// What an image says that fetches so many pages, each `times` times.
std::string imageOf(PageTraffic& traffic, uint64_t pages, int times) {
  traffic.begin();
  for (int i = 0; i < times; ++i)
    for (uint64_t page = 0; page < pages; ++page) traffic.fetched({page, 1}, kPage);
  return traffic.end(kMemory);
}

TEST(PageTraffic, IsReportedWherePagesComeOverAndOver) {
  PageTraffic traffic;
  EXPECT_EQ(imageOf(traffic, 10, 7),
            "images are slow: the rays of one image hit about 4.0 GB of geometry and structures on this "
            "rank, but only 0.5 GB are free for them, so each page was fetched 7 times; give ranks more "
            "memory (--memory), or start more ranks");
}

TEST(PageTraffic, IsNotReportedWherePagesComeOnceOrTwice) {
  PageTraffic traffic;
  EXPECT_EQ(imageOf(traffic, 10, 1), "");
  EXPECT_EQ(imageOf(traffic, 10, 2), "");
  EXPECT_EQ(imageOf(traffic, 0, 1), "");
}

TEST(PageTraffic, IsReportedAgainOnlyWhereMuchMoreIsMet) {
  PageTraffic traffic;
  EXPECT_NE(imageOf(traffic, 10, 4), "");
  EXPECT_EQ(imageOf(traffic, 10, 4), "");
  EXPECT_EQ(imageOf(traffic, 19, 5), "");
  EXPECT_NE(imageOf(traffic, 20, 5), "");
  EXPECT_EQ(imageOf(traffic, 20, 5), "");
}

}  // namespace
}  // namespace gluray::cluster
