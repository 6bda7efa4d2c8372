#include "base/background_job.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace gluray {
namespace {

int niceness() { return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())); }

BackgroundJob::Outcome endOf(BackgroundJob& job) {
  BackgroundJob::Outcome outcome = BackgroundJob::Outcome::none;
  for (int i = 0; i < 20'000 && outcome == BackgroundJob::Outcome::none; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    outcome = job.poll();
  }
  return outcome;
}

TEST(BackgroundJobs, OfLowPriorityAreNicerThanTheThreadThatStartsThem) {
  BackgroundJob job;
  int low = -100, usual = -100;
  ASSERT_TRUE(job.start([&](const std::atomic<bool>&) { low = niceness(); }));
  EXPECT_EQ(endOf(job), BackgroundJob::Outcome::done);
  ASSERT_TRUE(
      job.start([&](const std::atomic<bool>&) { usual = niceness(); }, BackgroundJob::Priority::usual));
  EXPECT_EQ(endOf(job), BackgroundJob::Outcome::done);
  EXPECT_EQ(usual, niceness());
  EXPECT_EQ(low, std::min(niceness() + 5, 19));
}

TEST(BackgroundJobs, ReportTheirEndOnce) {
  BackgroundJob job;
  EXPECT_FALSE(job.busy());
  ASSERT_TRUE(job.start([](const std::atomic<bool>&) { throw std::runtime_error("fails"); }));
  EXPECT_TRUE(job.busy());
  EXPECT_EQ(endOf(job), BackgroundJob::Outcome::failed);
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(job.poll(), BackgroundJob::Outcome::none);
}

TEST(BackgroundJobs, EndEarlyIfTheyAreCancelled) {
  BackgroundJob job;
  ASSERT_TRUE(job.start([](const std::atomic<bool>& cancelled) {
    while (!cancelled) std::this_thread::yield();
  }));
  EXPECT_EQ(job.poll(), BackgroundJob::Outcome::none);
  job.cancel();
  EXPECT_EQ(endOf(job), BackgroundJob::Outcome::failed);
}

}  // namespace
}  // namespace gluray
