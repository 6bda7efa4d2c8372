#include "parallel/loops.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
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

// Under the thread sanitizer: the end of the loop orders what a worker read before what the caller writes,
// even where the worker ends last, and its later calls have displaced the read from the sanitizer's history.
TEST(Workers, CallerMayWriteToWhatTheyHaveRead) {
  constexpr int kCalls = 1 << 23;  // twice what the history holds
  const auto caller = std::this_thread::get_id();
  const std::function<int(int)> increment = [](int n) { return n + 1; };
  int shown = 1;
  std::vector<int> sums(64);
  forEachPart(2, static_cast<int>(sums.size()), [&](int part) {
    int sum = shown;
    if (std::this_thread::get_id() != caller)
      while (sum <= kCalls) sum = increment(sum);
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    sums[static_cast<size_t>(part)] = sum;
  });
  shown = 2;
  for (const int sum : sums) EXPECT_TRUE(sum == 1 || sum == 1 + kCalls) << sum;
  EXPECT_EQ(shown, 2);
}

}  // namespace
}  // namespace gluray
