// Geometry larger than the memory of a rank: images are those of a process that has all of it.
#include "cluster/pages/page_split.h"
#include "cluster/pages/paged_mesh.h"
#include "cluster/testing/job_fixture.h"
#include "cluster/testing/program_ranks.h"
#include "scene/secondary_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace gluray::cluster {
namespace {

using gluray::test::makeMesh;
using gluray::test::MeshData;
using test::expectedImage;
using test::expectSame;

/// A sphere with bumps of 2 * rows * rows triangles, about `center`.
MeshData bumpySphere(int rows, const glm::vec3& center, float radius) {
  MeshData data;
  const auto columns = static_cast<uint32_t>(rows);
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= rows; ++j) {
      const float theta = std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(rows);
      const float phi = 2 * std::numbers::pi_v<float> * static_cast<float>(j) / static_cast<float>(rows);
      const glm::vec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      data.positions.push_back(center + n * radius * (1 + 0.1f * std::sin(9 * theta) * std::cos(7 * phi)));
      data.normals.push_back(n);
      data.colors.emplace_back(0.5f + 0.5f * n, 1);
    }
  for (uint32_t i = 0; i < columns; ++i)
    for (uint32_t j = 0; j < columns; ++j) {
      const uint32_t a = i * (columns + 1) + j, b = a + columns + 1;
      for (const uint32_t vertex : {a, b, a + 1, a + 1, b, b + 1}) data.indices.push_back(vertex);
    }
  return data;
}

MeshData soupOf(const MeshData& from) {
  MeshData soup;
  for (const uint32_t vertex : from.indices) {
    soup.positions.push_back(from.positions[vertex]);
    soup.normals.push_back(from.normals[vertex]);
  }
  return soup;
}

/// The same triangles in another order, in another colour.
MeshData reordered(MeshData data) {
  std::vector<std::array<uint32_t, 3>> triangles(data.indices.size() / 3);
  std::memcpy(triangles.data(), data.indices.data(), data.indices.size() * 4);
  std::shuffle(triangles.begin(), triangles.end(), std::mt19937(1));
  std::memcpy(data.indices.data(), triangles.data(), data.indices.size() * 4);
  for (glm::vec4& color : data.colors) color = {1, 0, 0, 1};
  return data;
}

/// Two bumpy spheres, one of them twice at the same place, a soup that is turned, and planes.
scene::Snapshot largeScene(int rows = 110, int size = 100) {
  scene::Snapshot s = frame::test::litScene(frame::test::Hides::some, size);
  s.settings.ao.enabled = false;
  const MeshData left = bumpySphere(rows, {-0.7f, 0, 0.8f}, 0.6f);
  const auto add = [&](const MeshData& data, const glm::dmat4& place, uint32_t order) {
    scene::Instance& instance = s.instances.emplace_back();
    auto mesh = makeMesh(data);
    mesh->lower = glm::vec3(-2), mesh->upper = glm::vec3(2);
    instance.mesh = mesh;
    instance.materials.resize(1);
    instance.eyeFromObject = s.eyeFromWorld * place;
    instance.worldFromObject = glm::mat4(place);
    instance.order = order;
  };
  add(left, glm::dmat4(1), 7);
  add(reordered(left), glm::dmat4(1), 7);  // of one draw: the later triangle wins
  add(soupOf(bumpySphere(rows, {0, 0, 0}, 0.5f)),
      glm::translate(glm::dmat4(1), {0.8, 0.2, 0.9}) * glm::rotate(glm::dmat4(1), 0.7, {1.0, 2.0, 0.5}), 8);
  s.laterWins = true;
  return s;
}

class Pages : public testing::Test {
 protected:
  /// As a job of so many ranks traces it with so much memory, which is too little.
  void expectSameInPages(const scene::Snapshot& snapshot, int ranks, size_t memory = 1'000'000) {
    test::WorkerJob job(folder_.directory(), ranks, "job", memory);
    test::Program program(folder_.directory());
    for (int i = 0; i < 2; ++i) expectSame(program.image(snapshot), expectedImage(snapshot));
    EXPECT_EQ(program.tracedHere, 0) << program.said;
    EXPECT_NE(job.said().find("larger than the memory of a rank"), std::string::npos) << job.said();
  }
  test::RuntimeFolder folder_;
};

TEST_F(Pages, GiveTheImageOfAllGeometry) { expectSameInPages(largeScene(), 2); }

TEST_F(Pages, GiveItToOneRank) { expectSameInPages(largeScene(), 1); }

TEST_F(Pages, GiveTheSameOcclusionAndShadows) {
  scene::Snapshot s = largeScene(90, 64);
  s.settings.ao.enabled = true, s.settings.ao.radius = 1;
  s.settings.shadows.enabled = true;
  s.settings.lights.rig = LightRig::threePoint;
  expectSameInPages(s, 3);
}

TEST_F(Pages, GiveTheSamePaths) {
  scene::Snapshot s = largeScene(70, 48);
  s.settings.integrator = LightIntegrator::path;
  expectSameInPages(s, 2, 500'000);
}

TEST_F(Pages, SurroundTheBatch) {
  scene::Snapshot s = largeScene(90, 64);
  s.settings.ao.enabled = true;
  auto around = std::make_shared<scene::SecondaryScene>();
  around->shadings = s.shadings;
  around->instances.push_back(s.instances.back());
  around->blended.push_back(false);
  s.instances.pop_back();
  s.secondaryScene = around;
  expectSameInPages(s, 2);
}

TEST_F(Pages, OfOtherDataComeInsteadOfTheFormer) {
  test::WorkerJob job(folder_.directory(), 2, "job", 1'000'000);
  test::Program program(folder_.directory());
  for (const int rows : {100, 120, 100, 90}) {
    const scene::Snapshot s = largeScene(rows, 48);
    expectSame(program.image(s), expectedImage(s));
  }
  const scene::Snapshot small = test::plainScene(48);
  expectSame(program.image(small), expectedImage(small));
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_F(Pages, ReachRanksThatHadTheGeometryBefore) {
  // First it fits, and all ranks have it; then more comes.
  test::WorkerJob job(folder_.directory(), 2, "job", 12'000'000);
  test::Program program(folder_.directory());
  scene::Snapshot s = largeScene(110, 48);
  s.instances.resize(s.instances.size() - 2);
  expectSame(program.image(s), expectedImage(s));
  EXPECT_EQ(job.said().find("larger than"), std::string::npos);
  s = largeScene(160, 48);
  expectSame(program.image(s), expectedImage(s));
  EXPECT_NE(job.said().find("larger than"), std::string::npos);
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_F(Pages, ThatComeOverAndOverAreReported) {
  scene::Snapshot s = largeScene(110, 48);
  s.settings.ao.enabled = true, s.settings.ao.radius = 2;
  test::WorkerJob job(folder_.directory(), 1, "job", 300'000);
  test::Program program(folder_.directory());
  expectSame(program.image(s), expectedImage(s));
  EXPECT_NE(job.said().find("each page was fetched"), std::string::npos) << job.said();
}

/// Parts of the ranks of a sort-last program, each part larger than the memory of a rank.
TEST_F(Pages, OfGatheredParts) {
  scene::Snapshot all = largeScene(100, 64);
  all.instances.erase(all.instances.end() - 2);  // at the very place of another one: the order would decide
  all.settings.gather = true, all.settings.ao.enabled = true, all.settings.ao.radius = 1;
  test::WorkerJob job(folder_.directory(), 2, "job", 1'000'000);
  test::ProgramRanks programs(folder_.directory(), 2);
  for (all.number = 1; all.number < 3; ++all.number) {
    all.frame = all.number;
    const Image image = test::composed(programs.images(all));
    EXPECT_EQ(test::differing(image, expectedImage(test::partsOf(all, {0, 1}, 2))), 0) << job.said();
  }
  EXPECT_TRUE(programs.allByWorkers());
  EXPECT_NE(job.said().find("larger than the memory of a rank"), std::string::npos) << job.said();
}

TEST(PageSplit, PutsEveryTriangleIntoOnePage) {
  MeshData data = bumpySphere(60, {0, 0, 0}, 1);
  data.positions[100].x = NAN;
  const auto mesh = makeMesh(data);
  const PageTable table = cutIntoPages(*mesh, 500);
  std::set<uint32_t> seen;
  EXPECT_GT(table.pages.size(), 2 * 60 * 60 / 500);
  for (const PageRange& page : table.pages) {
    EXPECT_LE(page.count, 500u);
    std::set<uint32_t> vertices;
    for (size_t i = page.first; i < page.first + page.count; ++i) {
      const uint32_t t = table.triangles[i];
      EXPECT_TRUE(seen.insert(t).second);
      if (i > page.first) { EXPECT_LT(table.triangles[i - 1], t); }
      bool finite = true;
      for (uint32_t k = 0; k < 3; ++k) {
        vertices.insert(mesh->corner(t, k));
        finite = finite && !std::isnan(mesh->position(mesh->corner(t, k)).x);
      }
      for (uint32_t k = 0; finite && k < 3; ++k) {
        const glm::vec3 p = mesh->position(mesh->corner(t, k));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(page.lower, p)) &&
                    glm::all(glm::lessThanEqual(p, page.upper)));
      }
    }
    EXPECT_EQ(page.vertices, vertices.size());
  }
  EXPECT_EQ(seen.size(), mesh->triangleCount);
}

TEST(PageSplit, KeepsWhatLiesInOnePlaceInOrder) {
  // The same triangle a thousand times, corners turned.
  MeshData data;
  for (uint32_t i = 0; i < 1000; ++i) {
    const glm::vec3 corner[3] = {{0.1f, 0.7f, 0}, {1.3f, 0, 0.9f}, {0, 2.1f, 0.3f}};
    for (uint32_t k = 0; k < 3; ++k) data.positions.push_back(corner[(i + k) % 3]);
  }
  const PageTable table = cutIntoPages(*makeMesh(data), 64);
  EXPECT_EQ(table.pages.size(), 16u);
  EXPECT_TRUE(std::ranges::is_sorted(table.triangles));
}

TEST(PageSplit, LeavesOutWhatCannotBeHit) {
  MeshData data;
  for (int i = 0; i < 300; ++i) data.positions.emplace_back(NAN, 1, 2);
  EXPECT_TRUE(cutIntoPages(*makeMesh(data), 10).pages.empty());
}

TEST(PagedMesh, HasTheArraysOfItsTriangles) {
  const MeshData data = bumpySphere(40, {0, 0, 0}, 1);
  scene::Instance instance;
  instance.mesh = makeMesh(data);
  const uint32_t count = instance.mesh->triangleCount;
  std::vector<uint32_t> colors(count + 5);
  for (uint32_t i = 0; i < colors.size(); ++i) colors[i] = 0xFF000000 | i;
  instance.triangleColors = gluray::test::makeAttribute(colors, scene::Format::unorm8x4);
  instance.triangleOffset = 5;
  const PagedMesh pages({1, 2}, instance, 200, 3);
  size_t triangles = 0;
  for (size_t page = 0; page < pages.count(); ++page) {
    scene::Mesh mesh = *pages.mesh(page);
    const auto& residence = static_cast<const PageResidence&>(*mesh.residence);
    EXPECT_EQ(residence.name.owner, 3);
    EXPECT_EQ(residence.name.whole.has_value(), page == 0);
    TriangleArrays arrays = residence.ofTriangles;
    std::vector<std::byte> content = pages.content(page);
    ASSERT_EQ(content.size(), pageBytes(mesh, arrays));
    layOut(mesh, arrays, {std::shared_ptr<void>(), content.data()});
    for (uint32_t t = 0; t < mesh.triangleCount; ++t) {
      uint32_t number, color;
      std::memcpy(&number, mesh.triangleNumbers.data + size_t{4} * t, 4);
      std::memcpy(&color, arrays[0].data + size_t{4} * t, 4);
      EXPECT_EQ(color, colors[number + 5]);
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t vertex = instance.mesh->corner(number, k);
        EXPECT_EQ(mesh.position(mesh.corner(t, k)), data.positions[vertex]);
        EXPECT_EQ(fetch(mesh.colors, mesh.corner(t, k)), data.colors[vertex]);
      }
    }
    triangles += mesh.triangleCount;
  }
  EXPECT_EQ(triangles, count);
}

}  // namespace
}  // namespace gluray::cluster
