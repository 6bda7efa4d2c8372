// Ascending indices, also for threads that build pages at the same time.
#include "accel/meshes/iota_indices.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

namespace gluray::accel {
namespace {

/// Whether the first `count` indices ascend from 0 and 16 bytes behind them can be read.
bool isIota(const std::shared_ptr<const uint32_t[]>& indices, size_t count) {
  for (size_t i = 0; i < count + 4; ++i)
    if (indices[i] != i) return false;
  return true;
}

TEST(IotaIndices, LongerRequestsLeaveEarlierArraysAlone) {
  IotaIndices iota;
  const auto few = iota.get(3), same = iota.get(300), many = iota.get(100000);
  EXPECT_EQ(few, same);
  EXPECT_NE(few, many);
  EXPECT_TRUE(isIota(few, 300));
  EXPECT_TRUE(isIota(many, 100000));
  EXPECT_EQ(iota.get(3), many);
}

TEST(IotaIndices, AreSharedByThreads) {
  for (int round = 0; round < 20; ++round) {
    IotaIndices iota;
    std::vector<std::thread> threads;
    for (size_t t = 0; t < 4; ++t)
      threads.emplace_back([&iota, t] {
        for (size_t i = 0; i < 50; ++i) {
          const size_t count = 1 + (i * 7919 + t * 104729) % 40000 + i * 1000;
          EXPECT_TRUE(isIota(iota.get(count), count)) << count;
        }
      });
    for (std::thread& thread : threads) thread.join();
  }
}

}  // namespace
}  // namespace gluray::accel
