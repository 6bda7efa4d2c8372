#include "accel/memory/free_memory.h"

#include "accel/cache/build_plan.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>

namespace gluray::accel {
namespace {

TEST(FreeMemory, FindsNumbersAfterNames) {
  constexpr const char* kText = "MemFree:   12 kB\nMemAvailable:    345 kB\ninactive_file 67\nMem 8";
  EXPECT_EQ(numberBehind(kText, "MemAvailable", 1), 345u);
  EXPECT_EQ(numberBehind(kText, "inactive_file", 1), 67u);
  EXPECT_EQ(numberBehind(kText, "Mem", 1), 8u);
  EXPECT_EQ(numberBehind(kText, "Available", 1), 1u);
  EXPECT_EQ(numberBehind("", "Mem", 1), 1u);
}

TEST(FreeMemory, IsBetweenZeroAndTheMachinesMemory) {
  std::stringstream text;
  text << std::ifstream("/proc/meminfo").rdbuf();
  const size_t total = numberBehind(text.str(), "MemTotal", 0) * 1024;
  ASSERT_GT(total, 0u);
  EXPECT_GT(freeMemory(), 0u);
  EXPECT_LE(freeMemory(), total);
}

TEST(FreeMemory, LimitsOfTheProcessCount) {
  constexpr size_t kRoom = size_t{100} << 20;  // freeMemory() itself allocates, above all under sanitizers
  for (const auto& [which, name] : {std::pair{RLIMIT_AS, "VmSize"}, std::pair{RLIMIT_DATA, "VmData"}}) {
    std::ifstream file("/proc/self/status");
    const std::string status{std::istreambuf_iterator<char>(file), {}};
    rlimit saved;
    ASSERT_EQ(getrlimit(which, &saved), 0);
    rlimit limited = saved;
    limited.rlim_cur = numberBehind(status, name, 0) * 1024 + kRoom;
    ASSERT_EQ(setrlimit(which, &limited), 0);
    const size_t left = freeMemory();
    ASSERT_EQ(setrlimit(which, &saved), 0);
    EXPECT_LE(left, kRoom + (size_t{1} << 20));  // some memory may have been freed
    EXPECT_GT(left, 0u);
  }
  EXPECT_GT(freeMemory(), kRoom);
}

size_t none() { return 0; }
size_t oneGigabyte() { return size_t{1} << 30; }
size_t plenty() { return size_t{1} << 40; }

TEST(BuildPlan, FollowsTheUsersSetting) {
  for (const BvhQuality wish : {BvhQuality::fast, BvhQuality::full, BvhQuality::compact, BvhQuality::least})
    EXPECT_EQ(firstQuality(wish, 5'000'000, {5'000'000, 0}, none), wish);
}

TEST(BuildPlan, AutomaticDependsOnSizeAndMemory) {
  const auto first = [](uint64_t triangles, uint64_t waiting, FreeMemory memory, bool runs = false) {
    return firstQuality(BvhQuality::automatic, triangles, {waiting, runs ? waiting : 0}, memory);
  };
  EXPECT_EQ(first(5'000, 5'000, plenty), BvhQuality::full);
  EXPECT_EQ(first(5'000, 5'000'000, plenty), BvhQuality::full);
  EXPECT_EQ(first(50'000, 5'000'000, plenty), BvhQuality::fast);
  EXPECT_EQ(first(1'500'000, 1'500'000, oneGigabyte), BvhQuality::fast);
  EXPECT_EQ(first(2'400'000, 2'400'000, oneGigabyte), BvhQuality::full);
  EXPECT_EQ(first(2'400'000, 2'400'000, oneGigabyte, true), BvhQuality::fast);
  EXPECT_EQ(first(6'000'000, 6'000'000, oneGigabyte, true), BvhQuality::fast);
  EXPECT_EQ(first(9'000'000, 9'000'000, oneGigabyte, true), BvhQuality::compact);
  const auto firstOf = [](const Waiting& waiting) {
    return firstQuality(BvhQuality::automatic, 3'000'000, waiting, oneGigabyte);
  };
  EXPECT_EQ(firstOf({3'100'000, 3'000'000}), BvhQuality::fast) << "small meshes beside a large one";
  EXPECT_EQ(firstOf({3'100'000, 1'500'000}), BvhQuality::full);
  EXPECT_EQ(first(9'000'000, 9'000'000, oneGigabyte), BvhQuality::compact);
  EXPECT_EQ(first(12'000'000, 12'000'000, oneGigabyte), BvhQuality::least);
  EXPECT_EQ(first(5'000'000, 5'000'000, none), BvhQuality::least);
  EXPECT_EQ(first(5'000, 5'000'000, none), BvhQuality::full);
}

TEST(BuildPlan, ThriftAppliesToLargeMeshes) {
  EXPECT_EQ(thriftyQuality(BvhQuality::full, 1'000'000), BvhQuality::least);
  EXPECT_EQ(thriftyQuality(BvhQuality::automatic, 1'000'000), BvhQuality::least);
  EXPECT_EQ(thriftyQuality(BvhQuality::compact, 100), BvhQuality::compact);
  EXPECT_EQ(thriftyQuality(BvhQuality::automatic, 100), BvhQuality::full);
}

TEST(BuildPlan, RefinesOnlyFastStructuresOfSettledGeometry) {
  EXPECT_TRUE(worthRefining(BvhQuality::automatic, BvhQuality::fast, 10));
  EXPECT_FALSE(worthRefining(BvhQuality::automatic, BvhQuality::fast, 1));
  EXPECT_FALSE(worthRefining(BvhQuality::automatic, BvhQuality::compact, 10));
  EXPECT_FALSE(worthRefining(BvhQuality::fast, BvhQuality::fast, 10));
  EXPECT_TRUE(roomToRefine(3'000'000, oneGigabyte));
  EXPECT_FALSE(roomToRefine(4'000'000, oneGigabyte));
}

}  // namespace
}  // namespace gluray::accel
