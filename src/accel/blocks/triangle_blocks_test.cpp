// Triangle blocks: they hold every triangle once, and hits equal those of Embree's triangles.
#include "accel/blocks/triangle_blocks.h"

#include "accel/blocks/triangle_bundles.h"
#include "accel/device/device.h"
#include "accel/device/error.h"
#include "accel/rays/next_hits.h"
#include "accel/testing/test_scene.h"
#include "accel/testing/test_sheets.h"
#include "accel/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

using namespace test;

struct OddTriangles final : HitFilter {
  bool accepts(uint32_t, uint32_t primitive, float, float, int) const noexcept override {
    return primitive % 2;
  }
};

struct TriangleBlocksTest : testing::TestWithParam<BvhQuality> {
  Arena arena{2};
  World blocks, triangles;
  const TriangleBlocks::Aim aim =
      GetParam() == BvhQuality::fast ? TriangleBlocks::Aim::speed : TriangleBlocks::Aim::memory;
  alignas(64) int32_t valid[kLanes];
  int hits = 0;

  TriangleBlocksTest() { std::fill_n(valid, kLanes, -1); }

  void show(scene::Snapshot snapshot) {
    snapshot.settings.bvh = GetParam();
    blocks.update(snapshot, arena);
    snapshot.settings.bvh = BvhQuality::compact;
    triangles.update(snapshot, arena);
    for (const scene::Instance& instance : snapshot.instances)
      EXPECT_TRUE(TriangleBlocks(*instance.mesh, aim).pay());
  }

  void compare(const HitFilter* filter, int leastHits = 4000) {
    for (uint32_t number = 0; number < 500; ++number) {
      RayPacket a = packetOf(number), b = packetOf(number);
      blocks.intersect(valid, a, filter);
      triangles.intersect(valid, b, filter);
      for (int i = 0; i < kLanes; ++i) compare(a, b, i);
    }
    EXPECT_GT(hits, leastHits);
  }

  void compare(const RayPacket& a, const RayPacket& b, int i) {
    ASSERT_EQ(a.geometry[i] == kNoHit, b.geometry[i] == kNoHit);
    EXPECT_EQ(a.tFar[i], b.tFar[i]);
    if (b.geometry[i] == kNoHit) return;
    ++hits;
    EXPECT_EQ(a.instance[i], b.instance[i]);
    if (a.primitive[i] != b.primitive[i]) return;  // a shared edge: either triangle is right
    EXPECT_EQ(a.u[i], b.u[i]);
    EXPECT_EQ(a.v[i], b.v[i]);
    EXPECT_EQ(a.normalX[i], b.normalX[i]);
    EXPECT_EQ(a.normalY[i], b.normalY[i]);
    EXPECT_EQ(a.normalZ[i], b.normalZ[i]);
  }
};

TEST_P(TriangleBlocksTest, HoldEveryTriangleOnce) {
  const auto mesh = makeMesh(sheets());
  const TriangleBlocks blocks(*mesh, aim);
  EXPECT_TRUE(blocks.pay());
  EXPECT_TRUE(TriangleBlocks::likely(*mesh, aim));
  TriangleBlocks computed(*mesh, aim);
  computed.forgetBoxes();
  EXPECT_EQ(blocks.first(0), 0u);
  EXPECT_EQ(blocks.first(blocks.count()), mesh->triangleCount);
  for (uint32_t c = 0; c < blocks.count(); ++c) {
    const Box box = blocks.boxOf(c), again = computed.boxOf(c);
    ASSERT_EQ(box.lower, again.lower);
    ASSERT_EQ(box.upper, again.upper);
    ASSERT_LT(blocks.first(c), blocks.first(c + 1));
    ASSERT_LE(blocks.first(c + 1) - blocks.first(c), aim == TriangleBlocks::Aim::memory ? 8u : 4u);
    for (uint32_t t = blocks.first(c); t < blocks.first(c + 1); ++t)
      for (uint32_t k = 0; k < 3; ++k) {
        const glm::vec3 p = mesh->position(mesh->corner(t, k));
        ASSERT_TRUE(glm::all(glm::lessThan(box.lower, p)) && glm::all(glm::lessThan(p, box.upper)));
      }
  }
}

TEST_P(TriangleBlocksTest, ConsecutiveDistantTrianglesAreSplit) {
  const auto mesh = makeMesh(shuffled(sheets()));
  EXPECT_FALSE(TriangleBlocks(*mesh, aim).pay());
  EXPECT_FALSE(TriangleBlocks::likely(*mesh, aim));
}

TEST_P(TriangleBlocksTest, HitsEqualThoseOfTriangles) {
  show(makeSnapshot({makeMesh(sheets())}));
  compare(nullptr);
}

TEST_P(TriangleBlocksTest, HitsEqualThoseOfTrianglesInSoup) {
  show(makeSnapshot({makeMesh(soupOf(sheets()))}));
  compare(nullptr);
}

TEST_P(TriangleBlocksTest, HitsEqualThoseOfTrianglesWithoutBundles) {
  const auto mesh = makeMesh(patches());
  EXPECT_FALSE(TriangleBundles(*mesh).pay());
  show(makeSnapshot({mesh}));
  compare(nullptr, 2000);
  hits = 0;
  const OddTriangles odd;
  compare(&odd, 1000);
}

TEST_P(TriangleBlocksTest, HitsEqualThoseOfTrianglesInInstances) {
  const auto mesh = makeMesh(sheets());
  auto snapshot = makeSnapshot({mesh, mesh});
  snapshot.instances[1].worldFromObject[3] = {0.3f, 0.1f, 0.05f, 1};
  show(snapshot);
  compare(nullptr);
}

TEST_P(TriangleBlocksTest, ApplyTheFilter) {
  show(makeSnapshot({makeMesh(sheets())}));
  const OddTriangles odd;
  compare(&odd);
}

TEST_P(TriangleBlocksTest, ResolveCoincidentTrianglesAlike) {
  const auto mesh = makeMesh(sheets());
  auto snapshot = makeSnapshot({mesh, mesh});
  snapshot.instances[1].order = 1;
  for (const bool laterWins : {false, true}) {
    snapshot.laterWins = laterWins;
    show(snapshot);
    ASSERT_TRUE(blocks.mayCoincide());
    compare(nullptr);
  }
}

TEST_P(TriangleBlocksTest, FindAllHitsOfARay) {
  show(makeSnapshot({makeMesh(sheets())}));
  int found = 0;
  for (uint32_t number = 0; number < 200; ++number) {
    RayPacket a = packetOf(number), b = packetOf(number);
    NextHits all, expected;
    blocks.intersectNext(valid, a, all, nullptr);
    triangles.intersectNext(valid, b, expected, nullptr);
    for (int i = 0; i < kLanes; ++i) {
      ASSERT_EQ(all.count(i), expected.count(i));
      for (int k = 0; k < all.count(i); ++k, ++found)
        EXPECT_EQ(all.at(i, k).distance, expected.at(i, k).distance);
    }
  }
  EXPECT_GT(found, 4000);
}

TEST_P(TriangleBlocksTest, TrianglesThatAreNotFiniteAreLeftOut) {
  MeshData data = sheets();
  for (size_t i = 7; i < data.positions.size() / 2; i += 50) data.positions[i].z = i % 2 ? NAN : INFINITY;
  show(makeSnapshot({makeMesh(data)}));
  compare(nullptr);
}

TEST_P(TriangleBlocksTest, ReplaceTrianglesWhenMemoryRunsOut) {
  MeshData data;
  for (int copy = 0; copy < 2; ++copy) {  // 32,768 triangles
    const MeshData part = sheets();
    const auto first = static_cast<uint32_t>(data.positions.size());
    for (const glm::vec3& p : part.positions) data.positions.push_back(p - glm::vec3(0, 0, 2 * copy));
    for (const uint32_t i : part.indices) data.indices.push_back(first + i);
  }
  auto snapshot = makeSnapshot({makeMesh(data)});
  const auto bytesOf = [&](World& world) {
    const size_t before = world.bytes();
    EXPECT_EQ(world.update(snapshot, arena).blasBuilds, 1u);
    return world.bytes() - before;
  };
  World least;
  snapshot.settings.bvh = BvhQuality::least;
  const size_t leastBytes = bytesOf(least);
  for (const BvhQuality wanted :
       {BvhQuality::automatic, BvhQuality::fast, BvhQuality::full, BvhQuality::compact}) {
    World world;
    snapshot.settings.bvh = wanted;
    failNextCommits(2);
    EXPECT_THROW(world.update(snapshot, arena), Error);  // the coarser structure fails, too
    failNextCommits(1);
    EXPECT_LT(bytesOf(world), leastBytes + leastBytes / 4) << "larger than the one asked for";
    EXPECT_EQ(commitsStillToFail(), 0);
    RayPacket packet = packetOf(3);
    world.intersect(valid, packet);
    EXPECT_TRUE(
        std::any_of(packet.geometry, packet.geometry + kLanes, [](uint32_t g) { return g != kNoHit; }));
  }
}

INSTANTIATE_TEST_SUITE_P(Structures, TriangleBlocksTest, testing::Values(BvhQuality::least, BvhQuality::fast),
                         [](const auto& quality) {
                           return quality.param == BvhQuality::least ? "least" : "fast";
                         });

}  // namespace
}  // namespace gluray::accel
