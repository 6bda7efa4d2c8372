// Meshes whose vertices move from frame to frame: their BLASes are refitted, and hits equal those of rebuilt
// BLASes.
#include "accel/meshes/deformation.h"

#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gluray::accel {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::MeshData;

constexpr int kWavesSide = 80;  // squares of a waves, of two triangles each

/// A waves over [-1, 1]^2 with travelling waves. `soup`: three vertices per triangle.
MeshData waves(float time, bool soup = false) {
  MeshData data;
  for (int y = 0; y <= kWavesSide; ++y)
    for (int x = 0; x <= kWavesSide; ++x) {
      const float u = 2.0f * static_cast<float>(x) / kWavesSide - 1,
                  v = 2.0f * static_cast<float>(y) / kWavesSide - 1;
      data.positions.push_back({u, v, 0.1f * std::sin(5 * u + time) * std::cos(4 * v - time)});
    }
  for (uint32_t y = 0; y < kWavesSide; ++y)
    for (uint32_t x = 0; x < kWavesSide; ++x) {
      const uint32_t i = y * (kWavesSide + 1) + x, above = i + kWavesSide + 1;
      data.indices.insert(data.indices.end(), {i, i + 1, above, i + 1, above + 1, above});
    }
  if (!soup) return data;
  MeshData corners;
  for (const uint32_t i : data.indices) corners.positions.push_back(data.positions[i]);
  return corners;
}

/// Distances and triangles that rays down -z hit.
std::vector<std::pair<float, uint32_t>> seen(const World& world) {
  std::vector<std::pair<float, uint32_t>> result;
  for (int k = 0; k < 60; ++k) {
    const float x = -1.0513f + 0.03497f * static_cast<float>(k);
    const RayPacket packet = test::shot(world, test::raysDown(x, -1.0307f, 0, 0.13711f));
    for (int i = 0; i < kLanes; ++i)
      result.emplace_back(packet.tFar[i], packet.geometry[i] == kNoHit ? kNoHit : packet.primitive[i]);
  }
  return result;
}

size_t differences(const std::vector<std::pair<float, uint32_t>>& a,
                   const std::vector<std::pair<float, uint32_t>>& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (++count < 4)
      ADD_FAILURE() << "ray " << i << ": " << a[i].first << ' ' << a[i].second << ", " << b[i].first << ' '
                    << b[i].second;
  }
  return count;
}

struct DeformationTest : testing::TestWithParam<bool> {
  Arena arena{2};
  World world;
  uint64_t refits = 0, builds = 0;
  BvhQuality bvh = BvhQuality::automatic;

  /// Expects the same hits as in a new world.
  void expectTrue(const MeshData& data, glm::mat4 place = glm::mat4(1)) {
    auto snapshot = makeSnapshot({makeMesh(data)});
    snapshot.instances[0].worldFromObject = place;
    snapshot.settings.bvh = bvh;
    const UpdateStatistics statistics = world.update(snapshot, arena);
    refits += statistics.blasRefits, builds += statistics.blasBuilds;
    World fresh;
    fresh.update(snapshot, arena);
    EXPECT_EQ(differences(seen(world), seen(fresh)), 0u);
  }
};

TEST_P(DeformationTest, MovingSheetsAreRefitted) {
  for (int i = 0; i < 12; ++i) expectTrue(waves(0.2f * static_cast<float>(i), GetParam()));
  EXPECT_EQ(refits, 8u);  // all but the first mesh, two ordinary builds, and one build to refit
  EXPECT_EQ(builds, 12u);
}

TEST_P(DeformationTest, RefittableStructuresReplaceTriangleBlocks) {
  bvh = BvhQuality::fast;
  EXPECT_TRUE(TriangleBlocks(*makeMesh(waves(0, GetParam())), TriangleBlocks::Aim::speed).pay());
  for (int i = 0; i < 12; ++i) expectTrue(waves(0.2f * static_cast<float>(i), GetParam()));
  EXPECT_EQ(refits, 8u);
}

TEST_P(DeformationTest, MovingSheetsAreRefittedUnderATransform) {
  glm::mat4 place(1);
  place[3] = {0.25f, 0, -1, 1};
  for (int i = 0; i < 8; ++i) {
    place[3].x += 0.01f;
    expectTrue(waves(0.2f * static_cast<float>(i), GetParam()), place);
  }
  EXPECT_EQ(refits, 4u);
}

TEST_P(DeformationTest, NonFiniteTrianglesAreLeftOutAndComeBack) {
  for (int i = 0; i < 12; ++i) {
    MeshData data = waves(0.2f * static_cast<float>(i), GetParam());
    if (i % 3 == 2) data.positions[data.positions.size() / 2].z = std::numeric_limits<float>::quiet_NaN();
    if (i == 7) data.positions[900].x = 1e30f;
    expectTrue(data);
  }
  for (int i = 0; i < 10; ++i) expectTrue(waves(3 + 0.2f * static_cast<float>(i), GetParam()));
  EXPECT_GT(refits, 4u);
}

INSTANTIATE_TEST_SUITE_P(Meshes, DeformationTest, testing::Bool(),
                         [](const auto& info) { return info.param ? "soup" : "indexed"; });

using Deforming = DeformationTest;

TEST_F(Deforming, OtherIndicesAreNotRefitted) {
  for (int i = 0; i < 10; ++i) {
    MeshData data = waves(0.2f * static_cast<float>(i));
    std::swap(data.indices[static_cast<size_t>(i) * 30], data.indices[static_cast<size_t>(i) * 30 + 5]);
    expectTrue(data);
  }
  EXPECT_EQ(refits, 0u);
}

TEST_F(Deforming, RecurringPositionsAreKept) {
  for (int i = 0; i < 60; ++i) expectTrue(waves(0.3f * static_cast<float>(i % 10)));
  EXPECT_LT(builds, 32u);
  EXPECT_LT(refits, 12u);
}

TEST_F(Deforming, ScatteredTrianglesAreRebuilt) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> anywhere(-1, 1);
  for (int i = 0; i < 30; ++i) {
    MeshData data = waves(0, true);
    for (size_t t = 0; t < data.positions.size(); t += 3) {
      const glm::vec3 away(anywhere(random), anywhere(random), anywhere(random));
      for (size_t k = 0; k < 3; ++k) data.positions[t + k] += away;
    }
    expectTrue(data);
  }
  EXPECT_EQ(refits, 0u);  // every triangle moves far each time
}

TEST_F(Deforming, TwoMovingMeshesAndAStaticOne) {
  const auto still = makeMesh(waves(100));
  for (int i = 0; i < 10; ++i) {
    const auto moved = [&](float t) { return makeMesh(waves(t + 0.2f * static_cast<float>(i))); };
    auto snapshot = makeSnapshot({moved(0), still, moved(50)});
    snapshot.instances[1].worldFromObject[3].z = -1;
    snapshot.instances[2].worldFromObject[3].z = -2;
    refits += world.update(snapshot, arena).blasRefits;
    World fresh;
    fresh.update(snapshot, arena);
    ASSERT_EQ(differences(seen(world), seen(fresh)), 0u) << i;
  }
  EXPECT_GT(refits, 8u);
}

TEST(Neighbours, SpreadGrowsWithTheGroups) {
  const auto rest = makeMesh(waves(0));
  const Neighbours neighbours(*rest);
  EXPECT_DOUBLE_EQ(neighbours.spreadIn(*rest), 1);
  MeshData large = waves(0);
  for (glm::vec3& p : large.positions) p = 7.0f * p + 3.0f;
  EXPECT_NEAR(neighbours.spreadIn(*makeMesh(large)), 1, 1e-3);  // uniform scaling spreads nothing
  EXPECT_LT(neighbours.spreadIn(*makeMesh(waves(0.3f))), 2);
  MeshData mixed = waves(0);
  std::shuffle(mixed.positions.begin(), mixed.positions.end(), std::mt19937(2));
  EXPECT_GT(neighbours.spreadIn(*makeMesh(mixed)), 20);
}

TEST(Deformations, LargeMotionsAreNotRefitted) {
  const auto mesh = makeMesh(waves(0));
  Deformations d;
  using Step = Deformations::Step;
  EXPECT_EQ(d.stepFor(*mesh, 0), Step::build);
  EXPECT_EQ(d.stepFor(*mesh, 0), Step::build);
  EXPECT_EQ(d.stepFor(*mesh, 0), Step::buildToRefit);
  EXPECT_EQ(d.stepFor(*mesh, 1.5), Step::refit);
  EXPECT_EQ(d.stepFor(*mesh, 5), Step::build);  // one refit does not make up for the slower build
  for (int i = 0; i < 30; ++i) EXPECT_EQ(d.stepFor(*mesh, 1), Step::build);
}

TEST(Deformations, SlowMotionsAreRebuiltAfterALongWay) {
  const auto mesh = makeMesh(waves(0));
  Deformations d;
  using Step = Deformations::Step;
  for (int i = 0; i < 3; ++i) d.stepFor(*mesh, 0);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(d.stepFor(*mesh, 1 + 0.1 * i), Step::refit);
  EXPECT_EQ(d.stepFor(*mesh, 2.1), Step::buildToRefit);
  EXPECT_EQ(d.stepFor(*mesh, 1), Step::refit);
}

TEST(AllInReach, FindsASingleVertexOutOfReach) {
  MeshData data = waves(0);
  EXPECT_TRUE(allInReach(*makeMesh(data)));
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity(), 2e18f}) {
    data.positions.back().y = bad;
    EXPECT_FALSE(allInReach(*makeMesh(data)));
  }
}

}  // namespace
}  // namespace gluray::accel
