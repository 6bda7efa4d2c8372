#include "control/link/apart.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <thread>

namespace gluray::control {
namespace {

TEST(Apart, DescriptorsAreSeparate) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  int opened = -1;
  bool seesPipe = true, hasNull = false;
  ASSERT_TRUE(runApart([&] {
    seesPipe = fcntl(ends[1], F_GETFD) == 0 && ends[1] > 2;
    hasNull = fcntl(STDERR_FILENO, F_GETFD) >= 0;
    for (int i = 0; i < 100; ++i) opened = open("/dev/null", O_RDONLY);
  }));
  EXPECT_FALSE(seesPipe);
  EXPECT_TRUE(hasNull);
  EXPECT_GT(opened, 100);
  EXPECT_EQ(fcntl(opened, F_GETFD), -1) << "visible to the process";
  EXPECT_GE(fcntl(ends[1], F_GETFD), 0) << "closed in the process";
  close(ends[0]), close(ends[1]);
}

/// The thread holds no copies of descriptors: readers of a pipe see its end when the process closes it.
TEST(Apart, PipesEndWhenTheProcessClosesThem) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  short events = 0;
  ASSERT_TRUE(runApart([&] {
    inProcess([&] {
      close(ends[1]);
      pollfd end{ends[0], POLLIN, 0};
      poll(&end, 1, 0);
      events = end.revents;
    });
  }));
  EXPECT_TRUE(events & POLLHUP);
  close(ends[0]);
}

TEST(Apart, TasksRunInTheProcess) {
  const auto here = std::this_thread::get_id();
  std::thread::id there, task;
  int file = -1;
  bool caught = false;
  ASSERT_TRUE(runApart([&] {
    there = std::this_thread::get_id();
    inProcess([&] { task = std::this_thread::get_id(), file = open("/dev/null", O_RDONLY); });
    try {
      inProcess([] { throw std::runtime_error("why"); });
    } catch (const std::runtime_error&) { caught = true; }
  }));
  EXPECT_NE(there, here);
  EXPECT_EQ(task, here);
  EXPECT_GE(fcntl(file, F_GETFD), 0);
  EXPECT_TRUE(caught);
  close(file);
  inProcess([&] { task = std::this_thread::get_id(); });
  EXPECT_EQ(task, here);
}

TEST(Apart, IsWoken) {
  int found = 0;
  ASSERT_TRUE(runApart([&] {
    pollfd wake{wakeDescriptor(), POLLIN, 0};
    ASSERT_GE(wake.fd, 0);
    EXPECT_EQ(poll(&wake, 1, 0), 0);
    const pthread_t self = pthread_self();
    inProcess([&] { wakeApart(self); });
    found = poll(&wake, 1, 10'000);
  }));
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace gluray::control
