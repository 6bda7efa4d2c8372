// Pages that are built while threads have other tasks.
#include "accel/pages/page_cache.h"
#include "accel/testing/fake_residence.h"
#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <thread>

namespace gluray::accel {
namespace {

using test::FakeResidence;
using test::makeSnapshot;
using test::MeshData;
using test::pageOf;
using test::raysDown;
using test::shot;
using test::Store;

/// The square [-1, 1]^2 in kSide x kSide cells: its triangles are split into several parts.
MeshData manyTriangles() {
  constexpr uint32_t kSide = 400;
  MeshData data;
  for (uint32_t y = 0; y <= kSide; ++y)
    for (uint32_t x = 0; x <= kSide; ++x)
      data.positions.emplace_back(2 * static_cast<float>(x) / kSide - 1,
                                  2 * static_cast<float>(y) / kSide - 1, 0);
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x) {
      const uint32_t a = y * (kSide + 1) + x, c = a + kSide + 1;
      data.indices.insert(data.indices.end(), {a, a + 1, c + 1, a, c + 1, c});
    }
  return data;
}

/// A page of many triangles alone in its world.
struct LargePage {
  Store store;
  World world{0};

  LargePage() {
    Arena arena(1);
    const MeshData data = manyTriangles();
    const auto residence = std::make_shared<FakeResidence>(store, data, std::nullopt);
    store.budget = 100 * residence->bytes();
    world.update(makeSnapshot({pageOf(data, residence)}), arena);
  }
};

thread_local bool t_inPage = false;

// A task of rays that meet the page would wait for ever for the thread that runs it.
TEST(PageCacheTasks, ThreadThatBuildsAPageRunsNoOtherTasks) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena arena(4);
  for (int round = 0; round < 5; ++round) {
    LargePage page;
    std::atomic<bool> done{false};
    std::atomic<int> others{0}, inPage{0};
    arena.execute([&] {
      tbb::task_group group;
      // There is always a task that waits for a thread, and there are threads that look for one.
      const std::function<void()> other = [&] {
        ++others, inPage += t_inPage;
        if (!done) group.run(other);
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      };
      group.run(other);
      while (others < 20) std::this_thread::yield();
      t_inPage = true;
      const RayPacket packet = shot(page.world, raysDown(0.1f, 0.1f, 0.01f, 0.003f));
      t_inPage = false;
      done = true;
      group.wait();
      for (int i = 0; i < kLanes; ++i) EXPECT_NE(packet.geometry[i], kNoHit);
    });
    EXPECT_EQ(page.store.loads, 1);
    ASSERT_EQ(inPage, 0);
  }
}

}  // namespace
}  // namespace gluray::accel
