// Several hits of each ray in one query.
#include "accel/rays/next_hits.h"

#include "accel/testing/test_scene.h"
#include "accel/world.h"
#include "parallel/arena.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace gluray::accel {
namespace {

NextHits::Hit hitAt(float distance, uint32_t primitive) { return {distance, 0, 0, 0, primitive}; }

TEST(NextHits, TheNearestAreKeptInOrder) {
  NextHits hits;
  std::vector<int> order(20);
  for (int i = 0; i < 20; ++i) order[static_cast<size_t>(i)] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  float farthest = 1000;
  for (const int i : order) {
    float distance = static_cast<float>(i);
    if (distance < farthest && hits.add(5, hitAt(distance, static_cast<uint32_t>(i)), distance))
      farthest = distance;
  }
  ASSERT_EQ(hits.count(5), NextHits::kMax);
  EXPECT_TRUE(hits.full(5));
  EXPECT_EQ(farthest, NextHits::kMax - 1);
  for (int i = 0; i < NextHits::kMax; ++i) EXPECT_EQ(hits.at(5, i).primitive, static_cast<uint32_t>(i));
  EXPECT_EQ(hits.count(4), 0);
}

TEST(NextHits, PassedHitsAreNotFoundAgain) {
  NextHits hits;
  float distance = 0;
  for (uint32_t i = 0; i < 8; ++i) hits.add(0, hitAt(1, i), distance);  // all at one distance
  EXPECT_LT(hits.passOn(0), 1);
  for (uint32_t i = 0; i < 12; ++i) hits.add(0, hitAt(1, i), distance);
  ASSERT_EQ(hits.count(0), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(hits.at(0, i).primitive, 8u + static_cast<uint32_t>(i));
}

/// All hits along a ray down the z axis through sheets at z = 0, -1, -2 ..., some of them coincident.
TEST(NextHits, EachOfManyLayersIsFoundOnce) {
  for (const bool twice : {false, true}) {
    constexpr int kSheets = 30;
    std::vector<scene::MeshPtr> meshes;
    for (int i = 0; i < kSheets; ++i) {
      meshes.push_back(test::makeMesh(test::squareData(-static_cast<float>(i))));
      if (twice) meshes.push_back(meshes.back());
    }
    const scene::Snapshot snapshot = test::makeSnapshot(meshes);
    Arena arena(1);
    World world;
    world.update(snapshot, arena);
    RayPacket packet = {};
    alignas(64) int32_t valid[kLanes] = {};
    NextHits hits;
    std::set<std::pair<uint32_t, uint32_t>> found;
    float from = 0;
    for (bool more = true; more;) {
      valid[3] = -1;
      packet.orgX[3] = 0.3f, packet.orgY[3] = 0.1f, packet.orgZ[3] = 5;
      packet.dirX[3] = packet.dirY[3] = 0, packet.dirZ[3] = -1;
      packet.tNear[3] = from, packet.tFar[3] = std::numeric_limits<float>::infinity();
      packet.mask[3] = ~0u, packet.id[3] = 3;
      for (int i = 0; i < kLanes; ++i) packet.geometry[i] = packet.instance[i] = kNoHit;
      world.intersectNext(valid, packet, hits, nullptr);
      for (int i = 0; i < hits.count(3); ++i) {
        const NextHits::Hit& hit = hits.at(3, i);
        EXPECT_TRUE(found.insert({hit.instance, hit.primitive}).second);
        const auto sheet = static_cast<float>(twice ? hit.instance / 2 : hit.instance);
        EXPECT_NEAR(hit.distance, 5 + sheet, 1e-4f);
      }
      more = hits.full(3);
      if (more) from = hits.passOn(3);
    }
    EXPECT_EQ(found.size(), static_cast<size_t>(twice ? 2 * kSheets : kSheets));
  }
}

}  // namespace
}  // namespace gluray::accel
