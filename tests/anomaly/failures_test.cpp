// Commits of acceleration structures fail, threads cannot be started: the image must stay the real
// OpenGL's, and stderr has at most one line.
#include "accel/device/device.h"
#include "base/files.h"
#include "tests/anomaly/image_of_all.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string>

namespace {
std::atomic<bool> g_noThreads{false};
std::atomic<int> g_refused{0};
}  // namespace

/// Replaces the C library's: TBB's and our own threads start here.
extern "C" __attribute__((visibility("default"))) int pthread_create(pthread_t* thread,
                                                                     const pthread_attr_t* attributes,
                                                                     void* (*run)(void*), void* argument) {
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto real = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  if (g_noThreads) return ++g_refused, EAGAIN;
  return real(thread, attributes, run, argument);
}

namespace gluray::test {
namespace {

using namespace anomaly;

long linesIn(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(Failures, EveryCommitMayFailOnce) {
  const DrawnImage expected = expectedImage();
  int n = 0;
  for (;; ++n) {
    TracedContext context({kSize, kSize});
    accel::failNextCommits(1, n);
    testing::internal::CaptureStderr();
    files::ownStreams();
    drawAll(context.gl());
    const DrawnImage got = context.read();
    const std::string said = testing::internal::GetCapturedStderr();
    const bool failed = accel::commitsStillToFail() == 0;
    accel::failNextCommits(0);
    EXPECT_EQ(wrongPixels(expected, got), 0) << "pixels, when commit " << n << " failed";
    EXPECT_LE(linesIn(said), 1) << said;
    if (!failed) break;  // fewer than n commits: each has failed once
  }
  EXPECT_GE(n, 2) << "commits in the whole image: of a mesh and of the instances";
}

/// In a process of its own, because threads are started once.
TEST(Failures, NoThreadCanBeStarted) {
  const DrawnImage expected = expectedImage();
  g_noThreads = true;
  Settings settings = TracedContext::vertexShading();
  settings.threads = 2;
  testing::internal::CaptureStderr();
  files::ownStreams();
  {
    TracedContext context({kSize, kSize}, settings);
    drawAll(context.gl());
    EXPECT_EQ(wrongPixels(expected, context.read()), 0);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  g_noThreads = false;
  EXPECT_LE(linesIn(said), 1) << said;
  EXPECT_GT(g_refused, 0) << "nobody asked for a thread";
}

}  // namespace
}  // namespace gluray::test
