#include "base/ample_stack.h"

#include "base/background_job.h"

#include <alloca.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <ucontext.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace gluray {
namespace {

/// Runs `work` on a thread with a stack of `bytes`.
void onThread(size_t bytes, std::function<void()> work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, bytes), 0);
  pthread_t thread;
  const auto run = [](void* object) -> void* {
    (*static_cast<std::function<void()>*>(object))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, &work), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

/// Touches `bytes` of the stack.
int useStack(size_t bytes) {
  auto* const room = static_cast<volatile char*>(__builtin_alloca(bytes));
  for (size_t i = 0; i < bytes; i += 512) room[i] = 1;
  return room[bytes / 1024 * 512];
}

TEST(AmpleStack, LargeStacksAreUsedInPlace) {
  onThread(size_t{4} << 20, [] {
    EXPECT_GT(stackLeft(), size_t{3} << 20);
    const pthread_t self = pthread_self();
    EXPECT_TRUE(onAmpleStack([&] { return pthread_equal(self, pthread_self()) != 0; }));
  });
}

TEST(AmpleStack, WorkOfSmallThreadsGetsALargerOne) {
  onThread(size_t{64} << 10, [] {
    EXPECT_LT(stackLeft(), size_t{64} << 10);
    const pthread_t self = pthread_self();
    EXPECT_FALSE(onAmpleStack([&] {
      useStack(kAmpleStack);
      return pthread_equal(self, pthread_self()) != 0;
    }));
    int done = 0;
    onAmpleStack([&] { ++done; });
    EXPECT_EQ(done, 1);
    EXPECT_EQ(onAmpleStack([] { return std::string("text"); }), "text");
  });
}

TEST(AmpleStack, ExceptionsReachTheCaller) {
  onThread(size_t{64} << 10,
           [] { EXPECT_THROW(onAmpleStack([] { throw std::runtime_error("why"); }), std::runtime_error); });
}

TEST(AmpleStack, NestedWorkStaysOnTheLargeStack) {
  onThread(size_t{64} << 10, [] {
    onAmpleStack([] {
      const pthread_t self = pthread_self();
      EXPECT_TRUE(onAmpleStack([&] { return pthread_equal(self, pthread_self()) != 0; }));
    });
  });
}

TEST(AmpleStack, SignalsOfTheHostAreBlocked) {
  onThread(size_t{64} << 10, [] {
    onAmpleStack([] {
      sigset_t mask;
      pthread_sigmask(SIG_SETMASK, nullptr, &mask);
      EXPECT_TRUE(sigismember(&mask, SIGALRM) && sigismember(&mask, SIGUSR1));
      EXPECT_FALSE(sigismember(&mask, SIGSEGV));
    });
  });
}

// A coroutine's stack is not the thread's.
ucontext_t g_caller, g_coroutine;
size_t g_left = 1;
TEST(AmpleStack, CoroutinesCountAsShort) {
  std::vector<char> stack(size_t{256} << 10);
  getcontext(&g_coroutine);
  g_coroutine.uc_stack.ss_sp = stack.data(), g_coroutine.uc_stack.ss_size = stack.size();
  g_coroutine.uc_link = &g_caller;
  makecontext(
      &g_coroutine, [] { g_left = stackLeft(); }, 0);
  swapcontext(&g_caller, &g_coroutine);
  EXPECT_EQ(g_left, 0u);
}

// GLuRay's own threads have enough stack whatever limit the program was started with. The test sets the
// default size instead of the limit.
TEST(AmpleStack, BackgroundJobsHaveRoomWhereTheDefaultIsSmall) {
  pthread_attr_t usual, small;
  ASSERT_EQ(pthread_getattr_default_np(&usual), 0);
  ASSERT_EQ(pthread_getattr_default_np(&small), 0);
  pthread_attr_setstacksize(&small, size_t{64} << 10);
  ASSERT_EQ(pthread_setattr_default_np(&small), 0);
  BackgroundJob job;
  size_t left = 0;
  const bool started = job.start([&](const std::atomic<bool>&) { left = stackLeft(); });
  pthread_setattr_default_np(&usual);
  pthread_attr_destroy(&usual), pthread_attr_destroy(&small);
  ASSERT_TRUE(started);
  while (job.poll() == BackgroundJob::Outcome::none)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_GT(left, size_t{1} << 20);
}

}  // namespace
}  // namespace gluray
