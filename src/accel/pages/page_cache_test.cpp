// Pages: what rays meet is what they meet in the whole mesh, however little memory there is.
#include "accel/pages/page_cache.h"

#include "accel/testing/fake_residence.h"
#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <optional>
#include <thread>

namespace gluray::accel {
namespace {

using test::bounded;
using test::FakeResidence;
using test::kInfinity;
using test::makeMesh;
using test::makeSnapshot;
using test::MeshData;
using test::pageOf;
using test::raysDown;
using test::shot;
using test::Store;

constexpr int kPages = 16;  // strips of kCells x kCells cells, from left to right
constexpr int kCells = 24;

/// Strip number `n` of a wavy surface over [-1, 1]^2.
MeshData strip(int n) {
  MeshData data;
  const auto at = [](int i, int j) {
    const float x = 2 * static_cast<float>(i) / (kPages * kCells) - 1;
    const float y = 2 * static_cast<float>(j) / kCells - 1;
    return glm::vec3(x, y, 0.2f * std::sin(9 * x) * std::cos(5 * y));
  };
  for (int j = 0; j <= kCells; ++j)
    for (int i = 0; i <= kCells; ++i) data.positions.push_back(at(n * kCells + i, j));
  constexpr uint32_t kRow = kCells + 1;
  for (uint32_t j = 0; j < kCells; ++j)
    for (uint32_t i = 0; i < kCells; ++i) {
      const uint32_t a = j * kRow + i;
      for (const uint32_t corner : {a, a + 1, a + kRow, a + kRow, a + 1, a + kRow + 1})
        data.indices.push_back(corner);
    }
  return data;
}

class PageCacheTest : public testing::Test {
 protected:
  PageCacheTest() {
    std::vector<scene::MeshPtr> whole, pages;
    for (int n = 0; n < kPages; ++n) {
      const MeshData data = strip(n);
      whole.push_back(bounded(data));
      std::optional<scene::Residence::Whole> first;
      if (n == 0) first = {glm::vec3(-1, -1, -0.2f), glm::vec3(1, 1, 0.2f), 0.2f};
      const auto residence = std::make_shared<FakeResidence>(store_, data, first);
      bytesOfPage_ = residence->bytes();
      pages.push_back(pageOf(data, residence));
    }
    whole_.update(makeSnapshot(whole), arena_);
    store_.budget = 100 * bytesOfPage_ * kPages;
    paged_.update(makeSnapshot(pages), arena_);
  }

  /// Shoots sixteen rays at each page, in another order for each `seed`.
  void expectSameHits(int seed = 0) {
    for (int n = 0; n < kPages; ++n) {
      const float x = 2 * (static_cast<float>((n * 7 + seed * 3) % kPages) + 0.1f) / kPages - 1;
      const RayPacket packet = raysDown(x, -0.9137f + 0.0103f * static_cast<float>(seed), 0.00613f, 0.10931f);
      const RayPacket expected = shot(whole_, packet), got = shot(paged_, packet);
      for (int i = 0; i < kLanes; ++i) {
        ASSERT_NE(expected.geometry[i], kNoHit);
        EXPECT_EQ(got.instance[i], expected.instance[i]);
        EXPECT_EQ(got.primitive[i], expected.primitive[i]);
        EXPECT_EQ(got.tFar[i], expected.tFar[i]);
        EXPECT_EQ(got.u[i], expected.u[i]);
        EXPECT_EQ(got.v[i], expected.v[i]);
      }
    }
  }

  Store store_;
  size_t bytesOfPage_ = 0;
  Arena arena_{2};
  World whole_, paged_{0};  // keeps no idle structures
};

TEST_F(PageCacheTest, LoadsWhatRaysMeetOnce) {
  EXPECT_EQ(store_.loads, 0);
  const RayPacket packet = shot(paged_, raysDown(-0.99f, -0.5f, 0.005f));
  EXPECT_NE(packet.geometry[0], kNoHit);
  EXPECT_EQ(store_.loads, 1);
  for (int seed = 0; seed < 3; ++seed) expectSameHits(seed);
  EXPECT_EQ(store_.loads, kPages);
  EXPECT_EQ(store_.drops, 0);
  EXPECT_EQ(paged_.pages().loads(), uint64_t{kPages});
}

TEST_F(PageCacheTest, KnowsTheBoundsWithoutLoading) {
  EXPECT_EQ(paged_.lower(), glm::vec3(-1, -1, -0.2f));
  EXPECT_EQ(paged_.upper(), glm::vec3(1, 1, 0.2f));
  EXPECT_EQ(store_.loads, 0);
}

TEST_F(PageCacheTest, StaysWithinItsBudget) {
  store_.budget = 12 * bytesOfPage_;  // two to five pages with their structures
  for (int seed = 0; seed < 4; ++seed) expectSameHits(seed);
  EXPECT_GT(store_.loads, 2 * kPages);
  EXPECT_GT(store_.drops, kPages);
  EXPECT_LE(paged_.pages().bytes(), store_.budget);
  EXPECT_LE(paged_.pages().mostBytes(), store_.budget + 2 * bytesOfPage_);
}

TEST_F(PageCacheTest, KeepsWhatWasMetLast) {
  store_.budget = 30 * bytesOfPage_;
  expectSameHits();
  const int before = store_.loads;
  for (int i = 0; i < 3; ++i)
    shot(paged_, raysDown(2 * 9.1f / kPages - 1, 0, 0.001f));  // the last of expectSameHits()
  EXPECT_EQ(store_.loads, before);
}

TEST_F(PageCacheTest, KeepsTheArraysThatReadersMayUse) {
  store_.budget = 1;
  {
    const PageCache::Reader reader(paged_.pages());
    expectSameHits();
    EXPECT_EQ(store_.loads, kPages);
    EXPECT_EQ(store_.drops, 0);
    {
      const PageCache::Reader later(paged_.pages());
      expectSameHits(1);  // structures are built again, arrays are there
      EXPECT_EQ(store_.loads, kPages);
    }
    EXPECT_EQ(store_.drops, 0);
  }
  EXPECT_GE(store_.drops, kPages - 1);
  EXPECT_EQ(store_.loads, kPages);
}

TEST_F(PageCacheTest, IsMetByOcclusionRays) {
  store_.budget = 12 * bytesOfPage_;
  for (int n = 0; n < 200; ++n) {
    OcclusionRays a{};
    for (int i = 0; i < kLanes; ++i) {
      a.orgX[i] = std::sin(static_cast<float>(n * 16 + i)),
      a.orgY[i] = std::cos(static_cast<float>(n * 5 + i * 3));
      a.orgZ[i] = 0.15f;
      a.dirX[i] = std::cos(static_cast<float>(n + i)), a.dirY[i] = std::sin(static_cast<float>(n + 2 * i));
      a.dirZ[i] = -0.3f, a.tFar[i] = 0.5f, a.mask[i] = ~0u;
    }
    OcclusionRays b = a;
    alignas(64) int32_t valid[kLanes];
    std::fill_n(valid, kLanes, -1);
    EXPECT_EQ(paged_.occluded(valid, a), whole_.occluded(valid, b));
  }
  EXPECT_GT(store_.loads, kPages);
}

TEST_F(PageCacheTest, HasNothingWhereLoadingFails) {
  store_.gone = true;
  int loads = 0;  // of a packet: Embree may trace it in parts
  for (int i = 1; i <= 2; ++i) {
    const RayPacket packet = shot(paged_, raysDown(0.3f, 0, 0.001f));
    for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(packet.geometry[lane], kNoHit);
    if (i == 1) loads = store_.loads;
    EXPECT_EQ(store_.loads, i * loads) << "each packet asks again";
    EXPECT_EQ(store_.drops, store_.loads);
  }
  EXPECT_GT(loads, 0);
  EXPECT_EQ(paged_.pages().bytes(), 0u);
  store_.gone = false;
  expectSameHits();
}

TEST_F(PageCacheTest, GivesAllMemoryBackWithItsPages) {
  expectSameHits();
  EXPECT_GT(paged_.pages().bytes(), size_t{kPages} * bytesOfPage_);
  paged_.update(makeSnapshot({makeMesh(test::squareData()), makeMesh(test::squareData(1))}), arena_);
  EXPECT_EQ(store_.drops, kPages);
  EXPECT_EQ(paged_.pages().bytes(), 0u);
}

TEST_F(PageCacheTest, ServesThreadsThatWantTheSamePages) {
  store_.budget = 8 * bytesOfPage_;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int seed = 0; seed < 8; ++seed) {
        const PageCache::Reader reader(paged_.pages());
        expectSameHits(seed + (t & 1));
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(paged_.pages().bytes(), store_.budget);
}

}  // namespace
}  // namespace gluray::accel
