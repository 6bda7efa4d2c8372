// Processes that exit during a background build.
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

namespace gluray::accel {
namespace {

scene::MeshPtr dunes() {
  constexpr uint32_t kRow = 800;
  test::MeshData data;
  for (uint32_t y = 0; y < kRow; ++y)
    for (uint32_t x = 0; x < kRow; ++x)
      data.positions.push_back({x, y, std::sin(0.1f * static_cast<float>(x + 3 * y))});
  for (uint32_t y = 0; y + 1 < kRow; ++y)
    for (uint32_t x = 0; x + 1 < kRow; ++x) {
      const uint32_t a = y * kRow + x, b = a + 1, c = a + kRow, d = c + 1;
      data.indices.insert(data.indices.end(), {a, b, d, a, d, c});
    }
  return test::makeMesh(data);
}

/// Starts a background build of a world that is never destroyed, as in a host.
void startRefining() {
  auto* world = new World(0, [] { return size_t{64} << 30; });
  auto* arena = new Arena(2);
  const auto snapshot = test::makeSnapshot({dunes()});
  for (int frame = 0; frame < 5; ++frame) world->update(snapshot, *arena);
}

TEST(RefinerExitDeathTest, ExitDuringABuild) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((startRefining(), std::exit(7)), testing::ExitedWithCode(7), "");
}

TEST(RefinerExitDeathTest, ForkedChildrenExitToo) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's allocator may be locked by the background thread when the process forks";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto forkAndWait = [] {
    startRefining();
    const pid_t child = fork();
    if (child == 0) std::exit(5);
    int status = 0;
    waitpid(child, &status, 0);
    std::exit(WIFEXITED(status) ? WEXITSTATUS(status) : 99);
  };
  EXPECT_EXIT(forkAndWait(), testing::ExitedWithCode(5), "");
}

}  // namespace
}  // namespace gluray::accel
