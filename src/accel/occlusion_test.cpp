// Occlusion queries against nearest hits: a ray is blocked exactly where it hits something, for every shape,
// structure and transform.
#include "accel/rays/occlusion.h"

#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

namespace gluray::accel {
namespace {

using scene::Shape;
using test::kInfinity;

/// The radical inverse of `i` to a prime base: spread evenly over [0, 1).
float halton(uint32_t i, uint32_t base) {
  float result = 0, digit = 1;
  for (; i; i /= base) {
    digit /= static_cast<float>(base);
    result += digit * static_cast<float>(i % base);
  }
  return result;
}
glm::vec3 haltonInCube(uint32_t i, uint32_t first = 0) {
  constexpr uint32_t kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23};
  const auto at = [&](uint32_t k) { return 2 * halton(i + 1, kPrimes[first + k]) - 1; };
  return {at(0), at(1), at(2)};
}

constexpr uint32_t kPrimitives = 300;

std::shared_ptr<scene::Mesh> triangles() {
  test::MeshData data;
  for (uint32_t i = 0; i < kPrimitives; ++i) {
    const glm::vec3 at = haltonInCube(i);
    for (uint32_t k = 0; k < 3; ++k) data.positions.push_back(at + 0.2f * haltonInCube(3 * i + k, 3));
  }
  return test::makeMesh(data);
}

/// A grid of many small triangles, which structures may hold as triangle blocks.
std::shared_ptr<scene::Mesh> grid() {
  constexpr uint32_t kSide = 150;
  test::MeshData data;
  for (uint32_t y = 0; y <= kSide; ++y)
    for (uint32_t x = 0; x <= kSide; ++x) {
      const float u = 2 * static_cast<float>(x) / kSide - 1, v = 2 * static_cast<float>(y) / kSide - 1;
      data.positions.emplace_back(u, v, 0.3f * std::sin(5 * u) * std::cos(4 * v));
    }
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x) {
      const uint32_t a = y * (kSide + 1) + x, b = a + kSide + 1;
      data.indices.insert(data.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  return test::makeMesh(data);
}

std::shared_ptr<scene::Mesh> impostors(Shape shape) {
  std::vector<glm::vec3> centers, axes;
  std::vector<float> radii;
  for (uint32_t i = 0; i < kPrimitives * scene::cornersOf(shape); ++i) {
    centers.push_back(haltonInCube(i));
    axes.push_back(0.4f * haltonInCube(i, 3));
    radii.push_back(0.02f + 0.1f * halton(i + 1, 23));
  }
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = shape;
  mesh->vertexCount = static_cast<uint32_t>(centers.size());
  mesh->triangleCount = kPrimitives;
  mesh->lower = glm::vec3(-1), mesh->upper = glm::vec3(1);
  mesh->geometryId = hashBytes(&shape, sizeof shape);
  mesh->positions = test::makeAttribute(centers, scene::Format::float3);
  if (shape == Shape::sticks) {
    std::vector<uint32_t> ends(centers.size());
    for (uint32_t i = 0; i < ends.size(); ++i)
      ends[i] = i % 5 < 2 ? scene::kClosedEnd | scene::kRoundEnd : i % 2;
    mesh->ends = test::makeAttribute(ends, scene::Format::uint32);
  }
  if (shape == Shape::cylinders) mesh->axes = test::makeAttribute(axes, scene::Format::float3);
  if (!scene::isSizedInPixels(shape)) mesh->radii = test::makeAttribute(radii, scene::Format::float1);
  return mesh;
}

/// The mesh, once in place and once moved, turned and scaled, in the view of a camera at the origin.
scene::Snapshot snapshotOf(const scene::MeshPtr& mesh, BvhQuality quality, const glm::dmat4& place) {
  scene::Snapshot s = test::makeSnapshot({mesh, mesh}, 100);
  s.settings.bvh = quality;
  s.camera.clipFromEye = glm::perspective(glm::radians(60.0), 1.0, 0.1, 100.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -6});
  s.instances[1].worldFromObject = glm::mat4(place);
  for (scene::Instance& instance : s.instances) {
    instance.eyeFromObject = s.eyeFromWorld * glm::dmat4(instance.worldFromObject);
    instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
    instance.impostors.size = {0.05f, 0.05f};
  }
  return s;
}

/// Packet `number` of rays between points of the scene, the lanes in `valid`.
void aim(uint32_t number, const glm::dmat4& place, OcclusionRays& rays, int32_t* valid) {
  for (int i = 0; i < kLanes; ++i) {
    const uint32_t n = number * kLanes + static_cast<uint32_t>(i);
    glm::vec3 from = 1.5f * haltonInCube(n), to = 1.5f * haltonInCube(n, 3);
    if (n % 2) {
      from = glm::vec3(place * glm::dvec4(from, 1));
      to = glm::vec3(place * glm::dvec4(to, 1));
    }
    const glm::vec3 dir = (to - from) * (n % 3 ? 1.0f : 0.25f);
    rays.orgX[i] = from.x, rays.orgY[i] = from.y, rays.orgZ[i] = from.z;
    rays.dirX[i] = dir.x, rays.dirY[i] = dir.y, rays.dirZ[i] = dir.z;
    rays.tNear[i] = n % 5 ? 0.0f : 0.1f;
    rays.tFar[i] = n % 7 ? kInfinity : 0.5f;
    valid[i] = n % 11 ? -1 : 0;
  }
}

RayPacket packetOf(const OcclusionRays& rays) {
  RayPacket packet{};
  const auto copy = [](const float(&from)[kLanes], float(&to)[kLanes]) { std::copy_n(from, kLanes, to); };
  copy(rays.orgX, packet.orgX), copy(rays.orgY, packet.orgY), copy(rays.orgZ, packet.orgZ);
  copy(rays.dirX, packet.dirX), copy(rays.dirY, packet.dirY), copy(rays.dirZ, packet.dirZ);
  copy(rays.tNear, packet.tNear), copy(rays.tFar, packet.tFar);
  for (int i = 0; i < kLanes; ++i) {
    packet.mask[i] = ~0u, packet.id[i] = static_cast<uint32_t>(i);
    packet.geometry[i] = packet.instance[i] = kNoHit;
  }
  return packet;
}

uint32_t lanesThatHit(const World& world, const int32_t* valid, const OcclusionRays& rays) {
  RayPacket packet = packetOf(rays);
  world.intersectBounced(valid, packet);
  uint32_t hits = 0;
  for (int i = 0; i < kLanes; ++i)
    if (valid[i] && packet.geometry[i] != kNoHit) hits |= 1u << i;
  return hits;
}

enum class Geometry { triangles, grid, spheres, discs, cylinders, beads, tubes, splats, sticks };
constexpr const char* kNames[] = {"triangles", "grid",  "spheres", "discs", "cylinders",
                                  "beads",     "tubes", "splats",  "sticks"};

scene::MeshPtr meshOf(Geometry geometry) {
  if (geometry == Geometry::triangles) return triangles();
  if (geometry == Geometry::grid) return grid();
  if (geometry == Geometry::sticks) return impostors(Shape::sticks);
  return impostors(static_cast<Shape>(static_cast<int>(geometry) - 1));
}

std::string nameOf(const testing::TestParamInfo<std::tuple<Geometry, BvhQuality, int>>& info) {
  const auto [geometry, quality, place] = info.param;
  return std::string(kNames[static_cast<int>(geometry)]) + "_" + std::to_string(static_cast<int>(quality)) +
         "_" + std::to_string(place);
}

const glm::dmat4 kPlaces[] = {
    glm::translate(glm::dmat4(1), {0.5, 0.25, -0.5}),
    glm::scale(glm::rotate(glm::translate(glm::dmat4(1), {4, 0, 0}), 1.0, {1, 2, 3}), glm::dvec3(0.5)),
    glm::scale(glm::dmat4(1), {3, 0.5, 1}),
};

class Occlusion : public testing::TestWithParam<std::tuple<Geometry, BvhQuality, int>> {};

TEST_P(Occlusion, IsWhereRaysHitSomething) {
  const auto [geometry, quality, number] = GetParam();
  const glm::dmat4& place = kPlaces[number];
  Arena arena{2};
  World world;
  world.update(snapshotOf(meshOf(geometry), quality, place), arena);
  int blocked = 0, open = 0;
  for (uint32_t n = 0; n < 120; ++n) {
    alignas(64) int32_t valid[kLanes];
    OcclusionRays rays;
    aim(n, place, rays, valid);
    const uint32_t hits = lanesThatHit(world, valid, rays);
    ASSERT_EQ(world.occluded(valid, rays), hits) << "packet " << n;
    blocked += std::popcount(hits), open += kLanes - std::popcount(hits);
  }
  EXPECT_GT(blocked, 100);
  EXPECT_GT(open, 100);
}

INSTANTIATE_TEST_SUITE_P(
    All, Occlusion,
    testing::Combine(testing::Values(Geometry::triangles, Geometry::grid, Geometry::spheres, Geometry::discs,
                                     Geometry::cylinders, Geometry::beads, Geometry::tubes, Geometry::splats,
                                     Geometry::sticks),
                     testing::Values(BvhQuality::fast, BvhQuality::full, BvhQuality::compact,
                                     BvhQuality::least),
                     testing::Range(0, 3)),
    nameOf);

/// Blocks rays only beyond a plane, and counts what it is asked.
class BeyondPlane : public OccluderFilter {
 public:
  explicit BeyondPlane(const glm::vec4& plane) : plane_(plane) {}
  bool blocks(const Occluder& occluder) const noexcept override {
    ++asked;
    return glm::dot(plane_, glm::vec4(occluder.point, 1)) >= 0;
  }
  mutable int asked = 0;

 private:
  glm::vec4 plane_;
};

/// Lets one of two primitives pass.
class EverySecond : public OccluderFilter {
 public:
  explicit EverySecond(bool usesPoints) : usesPoints_(usesPoints) {}
  bool blocks(const Occluder& occluder) const noexcept override {
    return occluder.primitive % 2 == 0 && (!usesPoints_ || std::isfinite(occluder.point.x));
  }
  bool usesPoints() const noexcept override { return usesPoints_; }

 private:
  bool usesPoints_;
};

class FilteredOcclusion : public testing::TestWithParam<Geometry> {};

TEST_P(FilteredOcclusion, AsksForThePointInObjectSpace) {
  Arena arena{2};
  World world;
  for (const BvhQuality quality : {BvhQuality::fast, BvhQuality::full, BvhQuality::least}) {
    world.update(snapshotOf(meshOf(GetParam()), quality, kPlaces[0]), arena);
    const BeyondPlane all({0, 0, 0, 1}), none({0, 0, 0, -1}), half({1, 0, 0, 0});
    const EverySecond withPoints(true), withoutPoints(false);
    int blockedByHalf = 0, blockedByAll = 0;
    for (uint32_t n = 0; n < 60; ++n) {
      alignas(64) int32_t valid[kLanes];
      const auto ask = [&](const OccluderFilter* filter) {
        OcclusionRays rays;
        aim(n, kPlaces[0], rays, valid);
        return world.occluded(valid, rays, filter);
      };
      const uint32_t plain = ask(nullptr), some = ask(&half);
      ASSERT_EQ(ask(&all), plain);
      ASSERT_EQ(ask(&none), 0u);
      ASSERT_EQ(some & ~plain, 0u);
      ASSERT_EQ(ask(&withoutPoints), ask(&withPoints));
      blockedByHalf += std::popcount(some), blockedByAll += std::popcount(plain);
    }
    EXPECT_LT(blockedByHalf, blockedByAll);
    EXPECT_GT(blockedByHalf, blockedByAll / 5);
    EXPECT_GT(none.asked, blockedByAll);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FilteredOcclusion,
                         testing::Values(Geometry::triangles, Geometry::grid, Geometry::spheres,
                                         Geometry::tubes),
                         [](const auto& info) { return std::string(kNames[static_cast<int>(info.param)]); });

TEST(OcclusionRays, ThatCannotBeTracedMeetNothing) {
  Arena arena{2};
  World world;
  world.update(test::makeSnapshot({test::makeMesh(test::squareData())}), arena);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  OcclusionRays rays{};
  alignas(64) int32_t valid[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    rays.orgZ[i] = 5, rays.dirZ[i] = -1, rays.tFar[i] = kInfinity;
    valid[i] = 1;  // any value but 0
  }
  rays.orgX[0] = nan, rays.orgX[1] = kInfinity, rays.orgX[2] = 1e30f, rays.tNear[3] = -1;
  rays.dirX[4] = nan, rays.dirY[5] = kInfinity, rays.tNear[6] = nan, rays.tFar[7] = nan;
  rays.dirZ[8] = 0, rays.tFar[9] = -1, rays.orgZ[10] = -kInfinity;
  EXPECT_EQ(world.occluded(valid, rays), 0xF800u);
}

TEST(OcclusionRays, OfAnEmptyWorldMeetNothing) {
  World world;
  OcclusionRays rays{};
  alignas(64) int32_t valid[kLanes];
  std::fill_n(valid, kLanes, -1);
  std::fill_n(rays.dirZ, kLanes, 1.0f), std::fill_n(rays.tFar, kLanes, 1.0f);
  EXPECT_EQ(world.occluded(valid, rays), 0u);
}

}  // namespace
}  // namespace gluray::accel
