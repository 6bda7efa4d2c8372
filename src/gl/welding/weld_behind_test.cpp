#include "gl/welding/weld_behind.h"

#include "gl/testing/test_soup.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <new>
#include <random>

namespace gluray::gl {
namespace {

using namespace test;

/// Captures a random walk that often revisits vertices, in several modes, and reads the run now and then.
CapturedVertices walk(Welding where, uint32_t seed) {
  constexpr GLenum kModes[] = {GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUADS};
  std::mt19937 random(seed);
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues(), 5000, where);
  const uint32_t kinds = random() % 2 ? 3 : 5, addsAt = random() % 12;
  uint32_t place = 0;
  for (uint32_t figure = 0; figure < 12; ++figure) {
    const float up[4] = {0, 0, 1, 0};
    if (figure == addsAt) stream.addSlot(kNormal, up);
    stream.begin(kModes[random() % kinds]);
    for (uint32_t i = random() % 30'000; i > 0; --i) {
      place = random() % 3 ? place + 1 : place - std::min<uint32_t>(place, random() % 50);
      stream.vertexSlow(static_cast<float>(place), static_cast<float>(place % 7), 0, 1);
      if (random() % 40'000 == 0) stream.captured();
    }
    stream.end();
  }
  return stream.takeRun();
}

TEST(WeldBehind, GivesTheSameRunAsWeldingOnTheCallingThread) {
  for (uint32_t seed = 1; seed <= 15; ++seed) {
    const CapturedVertices here = walk(Welding::here, seed), behind = walk(Welding::behind, seed);
    ASSERT_EQ(behind.primitives, here.primitives) << seed;
    ASSERT_EQ(behind.vertexCount, here.vertexCount) << seed;
    ASSERT_TRUE(
        std::equal(behind.indices.begin(), behind.indices.end(), here.indices.begin(), here.indices.end()))
        << seed;
    ASSERT_EQ(expanded(behind), expanded(here)) << seed;
  }
}

/// Runs `body` in a forked child and returns its result; -1 if it takes a minute or crashes.
template <class Body>
int inChild(Body&& body) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    _exit(body());
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryCanBeLimited = false;  // sanitizers reserve most of the address space
#else
constexpr bool kMemoryCanBeLimited = true;
#endif

/// Limits the address space to `moreBytes` beyond the present size; 0 lifts the limit.
void limitMemory(rlim_t moreBytes) {
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  file >> pages;
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = moreBytes ? pages * static_cast<rlim_t>(getpagesize()) + moreBytes : limit.rlim_max;
  setrlimit(RLIMIT_AS, &limit);
}

TEST(WeldBehind, LosesNothingIfMemoryIsShortForAWhile) {
  if (!kMemoryCanBeLimited) GTEST_SKIP() << "not with sanitizers";
  constexpr uint32_t kLarge = 600;
  const CapturedVertices soup = grid(kLarge, kNever, bit(kPosition));
  const auto shortOfMemory = [&] {
    VertexStream stream;
    stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, Welding::behind);
    stream.begin(GL_TRIANGLES);
    uint32_t sent = 0, failures = 0;
    forEachCorner(kLarge, [&](uint32_t x, uint32_t y) {
      if (++sent == 2 * kWeldFrom) limitMemory(1 << 20);
      const auto send = [&] {
        stream.vertexSlow(static_cast<float>(x), static_cast<float>(y), height(y, x), 1);
      };
      try {
        send();
      } catch (const std::bad_alloc&) {
        ++failures;
        limitMemory(0);
        send();
      }
    });
    stream.end();
    return failures == 1 && expanded(stream.takeRun()) == expanded(soup) ? 7 : 1;
  };
  EXPECT_EQ(inChild(shortOfMemory), 7);
}

TEST(WeldBehind, ThrowsInAForkedChildInsteadOfWaiting) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, Welding::behind);
  stream.begin(GL_TRIANGLES);
  sendGrid(stream, kSide);
  const auto goOn = [&] {
    try {
      stream.captured();
    } catch (const std::exception&) {
      stream.start(bit(kPosition), initialSlotValues());
      return 7;
    }
    return 1;
  };
  EXPECT_EQ(inChild(goOn), 7);
  EXPECT_EQ(stream.captured().indices.size(), 6u * kSide * kSide);  // the parent process continues
}

}  // namespace
}  // namespace gluray::gl
