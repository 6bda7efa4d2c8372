#include "parallel/loops.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace gluray {
namespace {

TEST(Workers, EveryPartIsDoneOnce) {
  for (const int threads : {1, 2, 3, 0}) {
    std::vector<std::atomic<int>> done(1000);
    forEachPart(threads, 1000, [&](int i) { ++done[static_cast<size_t>(i)]; });
    for (const auto& d : done) EXPECT_EQ(d, 1);
  }
  forEachPart(2, 0, [](int) { FAIL(); });
}

TEST(Workers, UsesAtMostTheGivenThreads) {
  for (const int threads : {1, 2}) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    forEachPart(threads, 200, [&](int) {
      std::this_thread::sleep_for(std::chrono::microseconds(50));
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    EXPECT_LE(seen.size(), static_cast<size_t>(threads));
  }
}

TEST(Workers, ExceptionsReachTheCaller) {
  EXPECT_THROW(forEachPart(2, 10, [](int i) { i == 7 ? throw std::runtime_error("seven") : void(); }),
               std::runtime_error);
}

TEST(Workers, SeveralCallersAtOnce) {
  std::atomic<int> sum{0};
  std::vector<std::thread> callers;
  for (int threads = 1; threads <= 4; ++threads)
    callers.emplace_back([&sum, threads] {
      for (int k = 0; k < 20; ++k) forEachPart(threads, 50, [&](int) { ++sum; });
    });
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(sum, 4 * 20 * 50);
}

}  // namespace
}  // namespace gluray
