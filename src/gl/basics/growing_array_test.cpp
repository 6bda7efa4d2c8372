#include "gl/basics/growing_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <numeric>
#include <utility>

namespace gluray::gl {
namespace {

bool counts(const GrowingArray<uint32_t>& a) {
  for (size_t i = 0; i < a.size(); ++i)
    if (a[i] != i) return false;
  return true;
}

TEST(GrowingArray, KeepsItsContentsWhenResized) {
  GrowingArray<uint32_t> a;
  for (const size_t count : {1ul, 1000ul, 300'000ul, 3'000'000ul, 3'000'001ul}) {
    const size_t before = a.size();
    a.grow(count);
    std::iota(a.begin() + before, a.end(), static_cast<uint32_t>(before));
    ASSERT_TRUE(counts(a)) << count;
    EXPECT_GE(a.capacity(), count);
  }
  for (const size_t count : {2'000'000ul, 1'000ul, 7ul, 0ul}) {
    a.resize(count);
    a.shrink(count);
    EXPECT_EQ(a.capacity(), count);
    ASSERT_TRUE(counts(a)) << count;
  }
}

TEST(GrowingArray, MovingKeepsTheElementsInPlace) {
  GrowingArray<uint32_t> a;
  a.resize(10);
  const uint32_t* data = a.data();
  GrowingArray<uint32_t> b = std::move(a);
  EXPECT_EQ(b.data(), data);
  EXPECT_EQ(a.data(), nullptr);
  EXPECT_EQ(a.size() + a.capacity(), 0u);
  b.clear();
  EXPECT_TRUE(b.empty());
  EXPECT_EQ(b.data(), data) << "memory is kept";
  b.release();
  EXPECT_EQ(b.data(), nullptr);
}

TEST(GrowingArray, IsUnchangedAfterAFailedAllocation) {
  GrowingArray<uint32_t> a;
  a.resize(1'000'000);
  std::iota(a.begin(), a.end(), 0u);
  EXPECT_THROW(a.reserve(size_t{1} << 58), std::bad_alloc);
  EXPECT_EQ(a.size(), 1'000'000u);
  EXPECT_TRUE(counts(a));
}

}  // namespace
}  // namespace gluray::gl
