#include "parallel/loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <map>
#include <mutex>
#include <numeric>
#include <thread>
#include <vector>

namespace gluray {
namespace {

bool signalsAreBlocked() {
  sigset_t mask;
  pthread_sigmask(SIG_SETMASK, nullptr, &mask);
  return sigismember(&mask, SIGALRM) && sigismember(&mask, SIGTERM) && sigismember(&mask, SIGUSR1);
}

/// The threads that work on many slow pieces, and whether each blocks the program's signals.
std::map<std::thread::id, bool> threadsOfALoop() {
  std::mutex mutex;
  std::map<std::thread::id, bool> seen;
  forPieces(200, 1, [&](size_t, size_t) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    const std::lock_guard lock(mutex);
    seen[std::this_thread::get_id()] = signalsAreBlocked();
  });
  return seen;
}

size_t threadsOfProcess() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<size_t>(std::distance(begin(tasks), end(tasks)));
}

class Parallel : public testing::Test {
  void TearDown() override { setSharedThreads(0); }
};

TEST_F(Parallel, UsesAtMostTheGivenThreads) {
  for (const int threads : {1, 2}) {
    setSharedThreads(threads);
    EXPECT_LE(threadsOfALoop().size(), static_cast<size_t>(threads));
  }
}

TEST_F(Parallel, WorkersBlockSignals) {
  setSharedThreads(2);
  for (const auto& [thread, blocked] : threadsOfALoop())
    EXPECT_EQ(blocked, thread != std::this_thread::get_id());
}

TEST_F(Parallel, OneThreadStartsNoOther) {
  setSharedThreads(1);
  const size_t before = threadsOfProcess();
  const std::vector<uint32_t> numbers(size_t{1} << 22, 7);
  std::vector<uint32_t> copy(numbers.size());
  copyLarge(copy.data(), numbers.data(), numbers.size() * sizeof(uint32_t));
  EXPECT_EQ(copy, numbers);
  copyNumbers(copy.data(), numbers.data(), numbers.size(), 3);
  EXPECT_EQ(copy.back(), 4u);
  EXPECT_EQ(extremesOf(numbers.data(), numbers.size()).most, 7u);
  hashLarge(numbers.data(), numbers.size() * sizeof(uint32_t));
  EXPECT_EQ(threadsOfProcess(), before);
}

TEST_F(Parallel, ResultsAreTheSameOnAnyNumberOfThreads) {
  std::vector<uint32_t> numbers((size_t{1} << 20) + 5);
  std::iota(numbers.begin(), numbers.end(), 11u);
  const size_t bytes = numbers.size() * sizeof(uint32_t);
  setSharedThreads(1);
  const Hash128 hash = hashLarge(numbers.data(), bytes);
  setSharedThreads(2);
  EXPECT_EQ(hashLarge(numbers.data(), bytes), hash);
  const Extremes extremes = extremesOf(numbers.data(), numbers.size());
  EXPECT_EQ(extremes.least, 11u);
  EXPECT_EQ(extremes.most, numbers.back());
  EXPECT_EQ(extremesOf(numbers.data(), 0).least, ~0u);
}

TEST_F(Parallel, EveryElementIsInOnePiece) {
  for (const size_t count : {size_t{0}, size_t{1}, size_t{100}, size_t{101}, size_t{5000}}) {
    std::vector<char> done(count);
    forPieces(count, 100, [&](size_t first, size_t last) {
      for (size_t i = first; i < last; ++i) ++done[i];
    });
    EXPECT_EQ(static_cast<size_t>(std::count(done.begin(), done.end(), 1)), count);
  }
}

}  // namespace
}  // namespace gluray
