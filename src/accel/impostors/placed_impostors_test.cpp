// Spheres, discs and cylinders against closed forms, and their independence of the camera.
#include "accel/impostors/placed_impostors.h"

#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

using scene::Shape;
using Billboards = scene::Impostors::Billboards;

std::shared_ptr<scene::Mesh> impostors(Shape shape, const std::vector<glm::vec3>& centers,
                                       std::vector<float> radii, const std::vector<glm::vec3>& axes = {}) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = shape;
  mesh->triangleCount = mesh->vertexCount = static_cast<uint32_t>(centers.size());
  mesh->positions = test::makeAttribute(centers, scene::Format::float3);
  mesh->radii = test::makeAttribute(std::move(radii), scene::Format::float1);
  mesh->axes = test::makeAttribute(axes, scene::Format::float3);
  mesh->geometryId = hashBytes(centers.data(), centers.size() * sizeof(glm::vec3));
  return mesh;
}

/// A ray's hit; t is infinity for misses.
struct Shot {
  float t = std::numeric_limits<float>::infinity();
  uint32_t instance = kNoHit, primitive = kNoHit;
};

struct Impostors : testing::Test {
  Arena arena{2};
  World world;
  scene::Snapshot snapshot(const std::vector<scene::MeshPtr>& meshes, bool parallel,
                           Billboards billboards = Billboards::silhouette) {
    scene::Snapshot s = test::makeSnapshot(meshes);
    for (scene::Instance& instance : s.instances) {
      instance.impostors.parallelView = parallel;
      instance.impostors.billboards = billboards;
    }
    return s;
  }
  /// Traces one ray in lane `lane`. World space is eye space.
  Shot shoot(const glm::vec3& org, const glm::vec3& dir, int lane = 0, float tFar = 1e6f) const {
    RayPacket packet{};
    PixelRays rays{};
    alignas(64) int32_t valid[kLanes] = {};
    for (int i = 0; i < kLanes; ++i) {
      packet.orgX[i] = rays.orgX[i] = org.x, packet.orgY[i] = rays.orgY[i] = org.y;
      packet.orgZ[i] = rays.orgZ[i] = org.z, packet.dirX[i] = rays.dirX[i] = dir.x;
      packet.dirY[i] = rays.dirY[i] = dir.y, packet.dirZ[i] = rays.dirZ[i] = dir.z;
      packet.tFar[i] = rays.tFar[i] = tFar;
      packet.mask[i] = ~0u;
      packet.geometry[i] = packet.instance[i] = kNoHit;
      packet.id[i] = static_cast<uint32_t>(i);
    }
    valid[lane] = -1;
    const ImpostorQuery query{&rays, &rays};
    world.intersect(valid, packet, nullptr, &query);
    if (packet.geometry[lane] == kNoHit) return {};
    return {packet.tFar[lane], packet.instance[lane], packet.primitive[lane]};
  }
};

TEST_F(Impostors, SphereHitsMatchTheEquation) {
  const std::vector<glm::vec3> centers = {{0, 0, -5}, {1, 0.5f, -8}, {-2, -1, -6}};
  const std::vector<float> radii = {1, 1.5f, 0.7f};
  world.update(snapshot({impostors(Shape::spheres, centers, radii)}, false), arena);
  EXPECT_TRUE(world.hasImpostors());
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 dir(0.6f * std::sin(1.3f * static_cast<float>(i)),
                        0.5f * std::cos(0.7f * static_cast<float>(i)), -1);
    double nearest = INFINITY;
    uint32_t which = kNoHit;
    for (uint32_t k = 0; k < 3; ++k) {
      const glm::dvec3 d(dir), c(centers[k]);
      const double b = glm::dot(d, c) / glm::dot(d, d);
      const double q = b * b - (glm::dot(c, c) - radii[k] * radii[k]) / glm::dot(d, d);
      if (q < 0 || b - std::sqrt(q) > nearest) continue;
      nearest = b - std::sqrt(q), which = k;
    }
    const Shot shot = shoot({0, 0, 0}, dir, i % kLanes);
    EXPECT_EQ(shot.primitive, which) << i;
    if (which == kNoHit) continue;
    ++hits;
    EXPECT_NEAR(shot.t, nearest, 1e-3);
    EXPECT_EQ(shot.instance, 0u);
  }
  EXPECT_GT(hits, 30);
}

TEST_F(Impostors, BillboardsCutSpheres) {
  const auto mesh = impostors(Shape::spheres, {{0, 0, -3}}, {1});
  world.update(snapshot({mesh}, true, Billboards::triangle), arena);
  // The triangle's lower side touches the unit circle.
  EXPECT_FLOAT_EQ(shoot({0, 0, 0}, {0, 0, -1}).t, 2);
  EXPECT_LT(shoot({0, -0.999f, 0}, {0, 0, -1}).t, 3);
  world.update(snapshot({mesh}, false, Billboards::triangle), arena);
  // From distance 3 the silhouette is wider than the circle: the triangle's lower side cuts it, its upper
  // corner does not.
  const float tangent = 1 / std::sqrt(8.0f), inside = 0.995f * tangent;
  EXPECT_EQ(shoot({0, 0, 0}, {0, -inside, -1}).primitive, kNoHit);
  EXPECT_EQ(shoot({0, 0, 0}, {0, inside, -1}).primitive, 0u);
  world.update(snapshot({mesh}, false), arena);
  EXPECT_EQ(shoot({0, 0, 0}, {0, -inside, -1}).primitive, 0u);
  EXPECT_EQ(shoot({0, 0, 0}, {0, 1.01f * tangent, -1}).primitive, kNoHit);
}

TEST_F(Impostors, InsideShowsTheFarSide) {
  scene::Snapshot s = snapshot({impostors(Shape::spheres, {{0, 0, -3}}, {1})}, true);
  s.instances[0].impostors.inside = true;
  world.update(s, arena);
  EXPECT_FLOAT_EQ(shoot({0, 0, 0}, {0, 0, -1}).t, 4);
}

TEST_F(Impostors, DiscsFaceTheViewer) {
  const glm::vec3 center(2, 0, -2);
  scene::Snapshot s = snapshot({impostors(Shape::discs, {center}, {1})}, false);
  s.instances[0].impostors.radiusDivisor = 2;
  world.update(s, arena);
  const glm::vec3 up(0, 1, 0), across = glm::normalize(glm::cross(center, up));
  for (const glm::vec3& side : {up, across, -across}) {
    EXPECT_NEAR(shoot({0, 0, 0}, center + 0.49f * side).t, 1, 1e-6);
    EXPECT_EQ(shoot({0, 0, 0}, center + 0.51f * side).primitive, kNoHit);
  }
}

TEST_F(Impostors, CylindersHaveOneEnd) {
  // Along z, from -4 to -6: the end towards the viewer is closed; the side shows the lateral surface.
  world.update(snapshot({impostors(Shape::cylinders, {{0, 0, -5}}, {0.5f}, {{0, 0, 2}})}, true), arena);
  EXPECT_FLOAT_EQ(shoot({0.3f, 0.3f, 0}, {0, 0, -1}).t, 4);
  EXPECT_EQ(shoot({0.4f, 0.4f, 0}, {0, 0, -1}).primitive, kNoHit);
  EXPECT_NEAR(shoot({2, 0, -5}, {-1, 0, 0}).t, 1.5, 1e-6);
  EXPECT_EQ(shoot({2, 0, -6.1f}, {-1, 0, 0}).primitive, kNoHit);
  // From behind it is open, and as in the programs its inside is invisible.
  EXPECT_EQ(shoot({0, 0, -9}, {0.05f, 0, 1}).primitive, kNoHit);
  // An axis that points away is reversed.
  world.update(snapshot({impostors(Shape::cylinders, {{0, 0, -5}}, {0.5f}, {{0, 0, -2}})}, true), arena);
  EXPECT_FLOAT_EQ(shoot({0.3f, 0.3f, 0}, {0, 0, -1}).t, 4);
}

TEST_F(Impostors, RadiiAreInLightingSpace) {
  scene::Snapshot s = snapshot({impostors(Shape::spheres, {{1, 0, -5}}, {1})}, true);
  const glm::mat4 stretched = glm::scale(glm::mat4(1), glm::vec3(3, 1, 1));
  s.instances[0].lightingFromObject = stretched;
  s.instances[0].eyeFromObject = glm::dmat4(stretched);
  s.instances[0].worldFromObject = stretched;
  world.update(s, arena);
  for (const float x : {2.1f, 3.0f, 3.9f}) EXPECT_EQ(shoot({x, 0, 0}, {0, 0, -1}).primitive, 0u) << x;
  for (const float x : {1.9f, 4.1f}) EXPECT_EQ(shoot({x, 0, 0}, {0, 0, -1}).primitive, kNoHit) << x;
}

TEST_F(Impostors, BehindNearPlaneAndViewer) {
  const auto mesh = impostors(Shape::spheres, {{0, 0, -1}}, {2});
  world.update(snapshot({mesh}, false, Billboards::triangle), arena);
  // The viewer is inside: the program's point is behind the viewer, so its depth is clamped to the far end.
  EXPECT_NEAR(shoot({0, 0, -0.5f}, {0, 0, -1}, 0, 100).t, 100, 1e-3);
  // A billboard in front of the near plane is clipped.
  EXPECT_EQ(shoot({0, 0, -1.5f}, {0, 0, -1}).primitive, kNoHit);
}

TEST_F(Impostors, PlanesClipByTheCentre) {
  scene::Snapshot s = snapshot({impostors(Shape::spheres, {{-1, 0, -5}, {1, 0, -5}}, {1.5f, 1.5f})}, true);
  s.instances[0].impostors.centerPlanes = {{1, 0, 0, 0}};
  world.update(s, arena);
  EXPECT_EQ(shoot({-0.4f, 0, 0}, {0, 0, -1}).primitive, 1u);
  EXPECT_EQ(shoot({-1, 0, 0}, {0, 0, -1}).primitive, kNoHit);
}

TEST_F(Impostors, TrianglesAndImpostorsHideEachOther) {
  const auto square = test::makeMesh(test::squareData(-3));
  world.update(snapshot({square, impostors(Shape::spheres, {{0, 0, -3}}, {0.5f})}, true), arena);
  EXPECT_EQ(shoot({0, 0, 0}, {0, 0, -1}).instance, 1u);
  EXPECT_EQ(shoot({0.8f, 0, 0}, {0, 0, -1}).instance, 0u);
  EXPECT_EQ(shoot({0, 0, -6}, {0, 0, 1}).instance, 1u);
}

TEST_F(Impostors, CameraRotationRebuildsNothing) {
  const auto spheres = impostors(Shape::spheres, {{0, 0, 0}, {1, 0, 0}}, {0.5f, 0.5f});
  const auto sticks =
      impostors(Shape::cylinders, {{0, 1, 0}, {1, 0, 0}}, {0.1f, 0.1f}, {{1, 0, 0}, {0.2f, 1, 0}});
  uint64_t builds = 0;
  for (int degrees = 0; degrees < 360; degrees += 7) {
    scene::Snapshot s = snapshot({spheres, sticks}, false);
    s.eyeFromWorld =
        glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), glm::radians(1.0 * degrees), {1, 2, 0.3});
    for (scene::Instance& instance : s.instances) {
      instance.eyeFromObject = s.eyeFromWorld;
      instance.lightingFromObject = glm::mat4(s.eyeFromWorld);
      instance.impostors.axisMatrix = glm::mat3(s.eyeFromWorld);
    }
    builds += world.update(s, arena).blasBuilds;
  }
  EXPECT_EQ(builds, 2u);
}

TEST_F(Impostors, InvalidImpostorsAreLeftOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  world.update(
      snapshot({impostors(Shape::spheres, {{nan, 0, -5}, {0, 0, -5}, {0, 3, -5}}, {1, 1, -1})}, true), arena);
  EXPECT_EQ(shoot({0, 0, 0}, {0, 0, -1}).primitive, 1u);
  EXPECT_EQ(shoot({0, 3, 0}, {0, 0, -1}).primitive, kNoHit);
}

}  // namespace
}  // namespace gluray::accel
