// Triangle bundles: they hold every triangle once, and rays alone or in packets hit Embree's triangles.
#include "accel/blocks/triangle_bundles.h"

#include "accel/testing/test_sheets.h"
#include "accel/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gluray::accel {
namespace {

using namespace test;

/// Kernels decode faces with a fused multiply-add or without, which round differently.
bool inside(const TriangleBundle& bundle, uint32_t block, const glm::vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const float base = bundle.base[axis], step = bundle.step[axis];
    const float below = bundle.lower[axis][block], above = bundle.upper[axis][block];
    const volatile float belowProduct = below * step, aboveProduct = above * step;  // rounded
    const float lower = std::max(base + belowProduct, std::fma(below, step, base));
    const float upper = std::min(base + aboveProduct, std::fma(above, step, base));
    if (p[axis] <= lower || p[axis] >= upper) return false;
  }
  return true;
}

/// Expects boxes to hold the vertices of their triangles, and returns how many bundles hold each triangle.
std::vector<int> holdersIn(const TriangleBundles& bundles, const scene::Mesh& mesh) {
  std::vector<int> holders(mesh.triangleCount);
  for (uint32_t i = 0; i < bundles.count(); ++i) {
    const TriangleBundle& bundle = bundles[i];
    const Box box = bundles.boxOf(i);
    EXPECT_TRUE(bundle.blocks >= 1 && bundle.blocks <= TriangleBundle::kBlocks);
    for (uint32_t b = 0; b < bundle.blocks; ++b)
      for (uint32_t n = 0; n < bundle.count[b]; ++n) {
        const uint32_t t = bundle.first + bundle.offset[b] + n;
        ++holders[t];
        for (uint32_t k = 0; k < 3; ++k) {
          const glm::vec3 p = mesh.position(mesh.corner(t, k));
          EXPECT_TRUE(inside(bundle, b, p));
          EXPECT_TRUE(glm::all(glm::lessThan(box.lower, p)) && glm::all(glm::lessThan(p, box.upper)));
        }
      }
  }
  return holders;
}

TEST(TriangleBundles, HoldEveryTriangleOnce) {
  const auto mesh = makeMesh(sheets());
  const TriangleBundles bundles(*mesh);
  EXPECT_TRUE(bundles.pay());
  EXPECT_TRUE(TriangleBundles::likely(*mesh));
  const std::vector<int> holders = holdersIn(bundles, *mesh);
  EXPECT_EQ(std::count(holders.begin(), holders.end(), 1), mesh->triangleCount);
}

TEST(TriangleBundles, DoNotPayWhereNeighboursAreFarApart) {
  const auto mesh = makeMesh(shuffled(sheets()));
  EXPECT_FALSE(TriangleBundles(*mesh).pay());
  EXPECT_FALSE(TriangleBundles::likely(*mesh));
}

TEST(TriangleBundles, LeaveOutTrianglesThatAreNotFinite) {
  MeshData data = sheets();
  for (size_t i = 7; i < data.positions.size(); i += 50) data.positions[i].y = i % 2 ? NAN : INFINITY;
  const auto mesh = makeMesh(data);
  const std::vector<int> holders = holdersIn(TriangleBundles(*mesh), *mesh);
  for (uint32_t t = 0; t < mesh->triangleCount; ++t) {
    bool finite = true;
    for (uint32_t k = 0; k < 3; ++k) finite &= std::isfinite(mesh->position(mesh->corner(t, k)).y);
    ASSERT_EQ(holders[t], finite ? 1 : 0);
  }
}

TEST(TriangleBundles, HoldTrianglesWithoutExtent) {
  for (const float size : {0.0f, 1e-42f, 1e-37f, 1e-36f, 1e-30f}) {
    MeshData data;
    for (int i = 0; i < 300; ++i) data.positions.push_back(glm::vec3(size * static_cast<float>(i % 7)));
    const auto mesh = makeMesh(data);
    const TriangleBundles bundles(*mesh);
    uint32_t held = 0;
    for (uint32_t i = 0; i < bundles.count(); ++i)
      for (uint32_t b = 0; b < bundles[i].blocks; ++b) held += bundles[i].count[b];
    EXPECT_EQ(held, mesh->triangleCount) << size;
  }
}

/// One bundle: a triangle from `from` on along x, over some million units, and small ones of which half begin
/// near `x` and half end there.
MeshData hugeAndSmall(float from, float x) {
  MeshData data;
  data.positions = {{from, -1e6f, -1e6f}, {from + 4.66e6f, 1e6f, -1e6f}, {from + 1e6f, 0, 1e6f}};
  for (int i = 0; i < 28; ++i) {
    const float at = x + 0.02f * static_cast<float>(i / 2 - 7), size = i % 2 ? -1 : 1;
    data.positions.insert(data.positions.end(), {{at, 0, 0}, {at + size, 1, 0}, {at + size, 0, 1}});
  }
  return data;
}

TEST(TriangleBundles, HoldSmallTrianglesBesideHugeOnes) {
  for (int i = 0; i < 300; ++i) {
    const float from = -1e6f - 1237.3f * static_cast<float>(i);
    const TriangleBundles any(*makeMesh(hugeAndSmall(from, 0)));
    ASSERT_EQ(any.count(), 1u);
    // Steps are coarse near 0, where floats are fine.
    const float base = any[0].base[0], step = any[0].step[0], face = base + std::ceil(-base / step) * step;
    const auto mesh = makeMesh(hugeAndSmall(from, face));
    const std::vector<int> holders = holdersIn(TriangleBundles(*mesh), *mesh);
    ASSERT_EQ(std::count(holders.begin(), holders.end(), 1), mesh->triangleCount);
    if (HasFailure()) FAIL() << "from " << from << ", near " << face;
  }
}

struct TriangleBundleRays : testing::TestWithParam<BvhQuality> {
  Arena arena{2};
  World bundles, triangles;

  TriangleBundleRays() {
    auto snapshot = makeSnapshot({makeMesh(sheets())});
    snapshot.settings.bvh = GetParam();
    bundles.update(snapshot, arena);
    snapshot.settings.bvh = BvhQuality::compact;
    triangles.update(snapshot, arena);
  }

  /// Traces packets with some valid lanes, whose rays `change` changes.
  template <class Change>
  void compare(uint32_t lanes, uint32_t leastHits, Change&& change) {
    alignas(64) int32_t valid[kLanes];
    uint32_t hits = 0;
    for (uint32_t number = 0; number < 500; ++number) {
      RayPacket a = packetOf(number);
      for (int i = 0; i < kLanes; ++i) {
        change(a, i);
        valid[i] = (lanes << number % kLanes) >> i & 1 ? -1 : 0;
      }
      RayPacket b = a;
      bundles.intersect(valid, a, nullptr);
      triangles.intersect(valid, b, nullptr);
      for (int i = 0; i < kLanes; ++i) {
        ASSERT_EQ(a.tFar[i], b.tFar[i]);
        ASSERT_EQ(a.geometry[i], b.geometry[i]);
        hits += a.geometry[i] != kNoHit;
      }
    }
    EXPECT_GE(hits, leastHits);
  }
};

TEST_P(TriangleBundleRays, SingleRaysHitWhatPacketsHit) {
  compare(1, 400, [](RayPacket&, int) {});
}

TEST_P(TriangleBundleRays, RaysBackwardsHit) {
  compare(0xFFFF, 3000, [](RayPacket& p, int i) { p.orgZ[i] = -5, p.dirZ[i] = 1; });
}

TEST_P(TriangleBundleRays, RaysAlongAxesHit) {
  compare(0xFFFF, 3000, [](RayPacket& p, int i) { p.dirX[i] = 0.0f, p.dirY[i] = i % 2 ? -0.0f : 0.0f; });
  compare(1, 400, [](RayPacket& p, int i) { p.dirX[i] = 0.0f, p.dirY[i] = i % 2 ? -0.0f : 0.0f; });
}

TEST_P(TriangleBundleRays, RaysOfAllDirectionsHit) {
  compare(0xFFFF, 1000, [](RayPacket& p, int i) {
    p.orgZ[i] = -0.5f;  // between the sheets
    p.dirX[i] = std::sin(static_cast<float>(i)), p.dirY[i] = std::cos(static_cast<float>(3 * i));
    p.dirZ[i] = i % 3 ? 1.0f : -1.0f;
  });
}

INSTANTIATE_TEST_SUITE_P(Structures, TriangleBundleRays, testing::Values(BvhQuality::least, BvhQuality::fast),
                         [](const auto& quality) {
                           return quality.param == BvhQuality::least ? "least" : "fast";
                         });

}  // namespace
}  // namespace gluray::accel
