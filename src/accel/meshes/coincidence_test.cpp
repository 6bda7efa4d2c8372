#include "accel/meshes/coincidence.h"

#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace gluray::accel {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::MeshData;
using test::squareData;

bool coincide(const std::vector<scene::MeshPtr>& meshes) {
  std::vector<const scene::Mesh*> all;
  for (const scene::MeshPtr& mesh : meshes) all.push_back(mesh.get());
  return anyCoincide(all, false);
}

/// The mesh with two corners of the triangle at index `at` swapped.
MeshData turned(MeshData data, size_t at) {
  std::swap(data.indices[at], data.indices[at + 1]);
  return data;
}

/// The square and a triangle beside it: a geometry of its own.
MeshData withNeighbour(MeshData data) {
  data.indices.insert(data.indices.end(), {4, 5, 6});
  for (const glm::vec3 p : {glm::vec3(2, 0, 0), glm::vec3(3, 0, 0), glm::vec3(2, 1, 0)})
    data.positions.push_back(p);
  return data;
}

TEST(Coincidence, DisjointSquaresDoNotCoincide) {
  EXPECT_FALSE(coincide({makeMesh(squareData(0)), makeMesh(squareData(1))}));
}

TEST(Coincidence, TrianglesOfTwoMeshes) {
  EXPECT_TRUE(coincide({makeMesh(squareData(0)), makeMesh(withNeighbour(squareData(0)))}));
}

TEST(Coincidence, CornersInAnyOrder) {
  MeshData data = squareData(0);
  data.indices = {0, 1, 2, 2, 1, 0};
  EXPECT_TRUE(coincide({makeMesh(data)}));
}

TEST(Coincidence, NegativeZeroIsZero) {
  EXPECT_TRUE(coincide({makeMesh(squareData(0.0f)), makeMesh(withNeighbour(squareData(-0.0f)))}));
}

TEST(Coincidence, DegenerateTrianglesAreIgnored) {
  MeshData data = squareData(0);
  data.indices = {0, 0, 1, 0, 0, 1, 2, 2, 2};
  EXPECT_FALSE(coincide({makeMesh(data)}));
}

/// A grid of side * side different squares, two triangles each.
MeshData grid(uint32_t side) {
  MeshData data;
  for (uint32_t y = 0; y <= side; ++y)
    for (uint32_t x = 0; x <= side; ++x) data.positions.push_back({x, y, 0.01f * static_cast<float>(x * y)});
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
      data.indices.insert(data.indices.end(), {a, b, d, a, d, c});
    }
  return data;
}

TEST(Coincidence, FindsOnePairAmongMany) {
  MeshData data = grid(150);
  EXPECT_FALSE(coincide({makeMesh(data)}));
  const size_t some = 3 * 31234;
  const std::vector<uint32_t> copy(data.indices.begin() + some, data.indices.begin() + some + 3);
  data.indices.insert(data.indices.end(), {copy[1], copy[0], copy[2]});
  EXPECT_TRUE(coincide({makeMesh(data)}));
}

std::vector<scene::Instance> instancesOf(const std::vector<scene::MeshPtr>& meshes) {
  return makeSnapshot(meshes).instances;
}

TEST(Coincidence, TransformsAreTakenIntoAccount) {
  Coincidence coincidence;
  auto instances = instancesOf({makeMesh(squareData(0)), makeMesh(squareData(0))});
  EXPECT_TRUE(coincidence.possible(instances));
  instances[1].worldFromObject[3].z = 1;
  EXPECT_FALSE(coincidence.possible(instances));
}

TEST(CoincidenceThread, LargeMeshesAreTestedInTheBackground) {
  Coincidence coincidence;
  const auto instances = instancesOf({makeMesh(grid(150))});
  EXPECT_TRUE(coincidence.possible(instances));
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  bool possible = true;
  while (possible && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    possible = coincidence.possible(instances);
  }
  EXPECT_FALSE(possible);
}

/// The instance that rays down -z at (x, y) hit, the same for every lane.
uint32_t seenAt(const World& world, float x, float y) {
  const RayPacket packet = test::shot(world, test::raysDown(x, y));
  for (int i = 1; i < kLanes; ++i) EXPECT_EQ(packet.instance[i], packet.instance[0]);
  return packet.instance[0];
}

/// Expects the order of drawing to decide which of the coplanar `meshes` is visible.
void expectOrderDecides(const std::vector<scene::MeshPtr>& meshes) {
  Arena arena{2};
  World world;
  scene::Snapshot snapshot = makeSnapshot(meshes);
  const auto count = static_cast<uint32_t>(meshes.size());
  for (const bool laterWins : {false, true})
    for (const bool backwards : {false, true}) {
      snapshot.laterWins = laterWins;
      for (uint32_t i = 0; i < count; ++i) snapshot.instances[i].order = backwards ? count - 1 - i : i;
      world.update(snapshot, arena);
      const uint32_t expected = laterWins != backwards ? count - 1 : 0;
      for (const float at : {-0.7f, -0.1f, 0.3f, 0.8f})
        EXPECT_EQ(seenAt(world, at, 0.5f * at), expected) << laterWins << backwards << " at " << at;
    }
}

TEST(DrawOrder, DecidesBetweenEqualTriangles) {
  expectOrderDecides({makeMesh(squareData(0)), makeMesh(withNeighbour(squareData(0)))});
}

TEST(DrawOrder, DecidesBetweenTrianglesTurnedOver) {
  expectOrderDecides({makeMesh(squareData(0.3f)), makeMesh(turned(turned(squareData(0.3f), 0), 3))});
}

TEST(DrawOrder, DecidesAmongMany) {
  std::vector<scene::MeshPtr> meshes;
  for (int i = 0; i < 9; ++i) {
    MeshData data = i % 2 ? turned(squareData(0.1f), 0) : squareData(0.1f);
    for (int k = 0; k < i; ++k) data = withNeighbour(data);
    meshes.push_back(makeMesh(data));
  }
  expectOrderDecides(meshes);
}

TEST(DrawOrder, FollowsTriangleOrderWithinAMesh) {
  MeshData data = squareData(0);
  data.indices = {0, 1, 2, 1, 2, 0, 0, 2, 1};
  Arena arena{2};
  World world;
  scene::Snapshot snapshot = makeSnapshot({makeMesh(data)});
  for (const bool laterWins : {false, true}) {
    snapshot.laterWins = laterWins;
    world.update(snapshot, arena);
    const RayPacket packet = test::shot(world, test::raysDown(0.5f, -0.5f));
    EXPECT_EQ(packet.primitive[0], laterWins ? 2u : 0u);
  }
}

TEST(DrawOrder, NearerSurfacesWinWhateverTheOrder) {
  Arena arena{2};
  World world;
  scene::Snapshot snapshot = makeSnapshot(
      {makeMesh(squareData(0)), makeMesh(squareData(0.001f)), makeMesh(withNeighbour(squareData(0)))});
  for (uint32_t i = 0; i < 3; ++i) snapshot.instances[i].order = i;
  for (const bool laterWins : {false, true}) {
    snapshot.laterWins = laterWins;
    world.update(snapshot, arena);
    EXPECT_EQ(seenAt(world, 0.2f, 0.1f), 1u);
  }
}

}  // namespace
}  // namespace gluray::accel
