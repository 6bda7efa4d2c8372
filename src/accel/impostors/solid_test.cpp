// Solids against their signed distance functions: hits lie on the surface, nothing lies before them, and the
// normal points outwards.
#include "accel/impostors/solid.h"

#include "accel/impostors/pixel_impostor.h"
#include "accel/impostors/solid_guess.h"
#include "accel/testing/test_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace gluray::accel {
namespace {

using scene::Shape;
using Distance = std::function<double(const glm::dvec3&)>;  // of a point in lighting space, negative inside

struct SolidScene {
  scene::Camera camera;
  scene::Instance instance;
  PlacedImpostors placed;

  SolidScene(Shape shape, std::vector<glm::vec3> points, float radius, const glm::dmat4& lightingFromObject) {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->shape = shape, mesh->radius = radius;
    mesh->vertexCount = static_cast<uint32_t>(points.size());
    mesh->triangleCount = 1;
    mesh->positions = test::makeAttribute(std::move(points), scene::Format::float3);
    mesh->axes = test::makeAttribute<glm::vec3>({{1, 2, 0.5f}}, scene::Format::float3);
    instance.mesh = mesh;
    instance.eyeFromObject = lightingFromObject;
    instance.lightingFromObject = glm::mat4(lightingFromObject);
    camera.viewport = {0, 0, 200, 200};
    camera.clipFromEye = glm::perspective(glm::radians(60.0), 1.0, 1.0, 100.0);
    place();
  }
  void place() {
    placed = PlacedImpostors(instance, camera);
    if (scene::isInWindow(instance.mesh->shape)) placed.window = windowVertices(placed);
  }
};

/// Rays of all directions about and within `reach` of a point.
template <class Each>
void eachRay(const glm::dvec3& about, double reach, Each&& each) {
  for (int i = 0; i < 4000; ++i) {
    const double a = 2.399963 * i, z = 1 - (2 * i + 1) / 4000.0, r = std::sqrt(1 - z * z);
    const glm::dvec3 dir(r * std::cos(a), r * std::sin(a), z);
    const glm::dvec3 aside(std::sin(7.1 * i), std::cos(5.3 * i), std::sin(3.7 * i));
    each(about + reach * (1.2 * aside - (i % 4 ? 2.0 : 0.0) * dir), dir * (i % 3 ? 1.0 : 4.0));
  }
}

void expectAgrees(const SolidScene& scene, const Distance& distance, const glm::dvec3& about, double reach) {
  const glm::dmat4 lightingFromObject(scene.placed.lightingFromObject);
  const glm::dmat4 objectFromLighting = glm::inverse(lightingFromObject);
  const double little = 1e-5 * reach;
  int hits = 0, misses = 0;
  eachRay(about, reach, [&](const glm::dvec3& org, const glm::dvec3& dir) {
    ObjectRay ray{glm::vec3(objectFromLighting * glm::dvec4(org, 1)),
                  glm::vec3(glm::dmat3(objectFromLighting) * dir), 0, std::numeric_limits<float>::infinity()};
    const auto at = [&](double t) {
      return glm::dvec3(lightingFromObject * glm::dvec4(glm::dvec3(ray.org) + t * glm::dvec3(ray.dir), 1));
    };
    const std::optional<SolidHit> hit = meetSolid(scene.placed, 0, ray);
    const double end = hit ? hit->t : 6 * reach / glm::length(dir);
    const bool fromInside = distance(at(0)) < 0;
    if (fromInside && scene::isSizedInPixels(scene.placed.mesh->shape)) {
      ASSERT_TRUE(!hit || distance(at(0)) > -little) << "rays leave beads and tubes";
      return;
    }
    for (int k = 1; k < 200; ++k) {
      const double d = distance(at(end * k / 200));
      ASSERT_TRUE(fromInside ? d < little : d > -little) << "something lies before the hit";
    }
    (hit ? hits : misses) += 1;
    if (!hit) return;
    ASSERT_NEAR(distance(at(hit->t)), 0, little);
    const glm::dvec3 normal = glm::normalize(glm::inverse(glm::transpose(glm::dmat3(lightingFromObject))) *
                                             glm::dvec3(hit->normal));
    const double step = 0.01 * reach, along = distance(at(hit->t) + step * normal);
    ASSERT_NEAR(along, step, 0.05 * step) << "the normal leads away from the surface";
  });
  EXPECT_GT(hits, 300);
  EXPECT_GT(misses, 300);
}

const glm::dmat4 kTurned =
    glm::scale(glm::rotate(glm::translate(glm::dmat4(1), {1, 2, -9}), 0.7, {1, 2, 3}), glm::dvec3(0.5));
glm::dvec3 inLighting(const glm::dvec3& object) { return glm::dvec3(kTurned * glm::dvec4(object, 1)); }

TEST(Solid, SpheresAreBalls) {
  const SolidScene scene(Shape::spheres, {{1, 0, 0}}, 0.8f, kTurned);
  const glm::dvec3 center = inLighting({1, 0, 0});
  expectAgrees(
      scene, [&](const glm::dvec3& p) { return glm::distance(p, center) - 0.8f; }, center, 0.8);
}

/// Billboards of constant z are clipped as a whole: spheres beyond near and far plane block nothing.
TEST(Solid, SpheresWithSquaresAreThereOnlyBetweenNearAndFarPlane) {
  constexpr float kRadius = 2;
  const auto blocks = [&](float z, scene::Impostors::Billboards billboards) {
    SolidScene scene(Shape::spheres, {{0, 0, z}}, kRadius, glm::dmat4(1));
    scene.instance.impostors.billboards = billboards;
    scene.place();
    const ObjectRay across{{-10, 0, z}, {1, 0, 0}, 0, 100};
    EXPECT_EQ(meetSolid(scene.placed, 0, across).has_value(), hullOf(scene.placed, 0).has_value());
    return meetSolid(scene.placed, 0, across).has_value();
  };
  using Billboards = scene::Impostors::Billboards;
  for (const float z : {-2.0f, -50.0f, -99.0f}) EXPECT_TRUE(blocks(z, Billboards::square)) << z;
  for (const float z : {1.0f, -0.9f, -101.0f}) {
    EXPECT_FALSE(blocks(z, Billboards::square)) << z;
    EXPECT_TRUE(blocks(z, Billboards::silhouette)) << z;
  }
}

TEST(Solid, CylindersAreClosedAtBothEnds) {
  const SolidScene scene(Shape::cylinders, {{1, 0, 0}}, 0.4f, kTurned);
  const glm::dvec3 center = inLighting({1, 0, 0}), axis = glm::normalize(glm::dvec3(1, 2, 0.5));
  const double half = 0.5 * glm::length(glm::dvec3(1, 2, 0.5));
  const Distance distance = [&](const glm::dvec3& p) {
    const double along = glm::dot(p - center, axis);
    const glm::dvec2 d(glm::length(p - center - along * axis) - 0.4f, std::abs(along) - half);
    return std::min(std::max(d.x, d.y), 0.0) + glm::length(glm::max(d, 0.0));
  };
  expectAgrees(scene, distance, center, 1.2);
}

TEST(Solid, BeadsAreAsWideAsInTheWindow) {
  SolidScene scene(Shape::beads, {{1, 0, 0}}, 1, kTurned);
  scene.instance.impostors.size = {0.1f, 0.1f};
  scene.place();
  const glm::dvec3 center = inLighting({1, 0, 0});
  const double radius = 0.05 * -center.z * std::tan(glm::radians(30.0));
  expectAgrees(
      scene, [&](const glm::dvec3& p) { return glm::distance(p, center) - radius; }, center, radius);
}

TEST(Solid, TubesAreRoundCones) {
  SolidScene scene(Shape::tubes, {{-1, 0, -2}, {1, 1, 3}}, 1, kTurned);
  scene.instance.impostors.size = {0.2f, 0.2f};
  scene.place();
  const glm::dvec3 a = inLighting({-1, 0, -2}), b = inLighting({1, 1, 3});
  const double perDepth = 0.1 * std::tan(glm::radians(30.0));
  const double ra = perDepth * -a.z, rb = perDepth * -b.z;
  // The ball of the family between the ends that is nearest to the point (I. Quilez, "Round cone").
  const Distance distance = [&](const glm::dvec3& p) {
    const double length = glm::distance(a, b), sine = (ra - rb) / length, cosine = std::sqrt(1 - sine * sine);
    const glm::dvec3 axis = (b - a) / length;
    const double along = glm::dot(p - a, axis), aside = glm::length(p - a - along * axis);
    const double place = along + aside * sine / cosine * -1.0;
    const double share = std::clamp(place / length, 0.0, 1.0);
    return glm::distance(p, glm::mix(a, b, share)) - std::lerp(ra, rb, share);
  };
  EXPECT_GT(std::abs(ra - rb), 0.02);
  expectAgrees(scene, distance, 0.5 * (a + b), 0.5 * glm::distance(a, b));
}

TEST(Solid, SplatsAreBallsInObjectSpace) {
  const SolidScene scene(Shape::splats, {{1, 0, 0}}, 0.8f, kTurned);
  const glm::dvec3 center = inLighting({1, 0, 0});
  expectAgrees(
      scene, [&](const glm::dvec3& p) { return glm::distance(p, center) - 0.5 * 0.8f; }, center, 0.4);
}

TEST(Solid, DiscsBlockFromBothSides) {
  const SolidScene scene(Shape::discs, {{0, 0, 0}}, 1, glm::translate(glm::dmat4(1), {0, 0, -5}));
  const auto meets = [&](const glm::vec3& org, const glm::vec3& dir) {
    return meetSolid(scene.placed, 0, {org, dir, 0, 100}).has_value();
  };
  EXPECT_TRUE(meets({0.9f, 0, 3}, {0, 0, -1}));
  EXPECT_TRUE(meets({0.9f, 0, -3}, {0, 0, 1}));
  EXPECT_FALSE(meets({1.1f, 0, 3}, {0, 0, -1}));
  EXPECT_FALSE(meets({0.9f, 0, 3}, {0, 0, 1}));
  EXPECT_FALSE(meets({0, -3, 0.1f}, {0, 1, 0}));
}

TEST(Solid, PlanesCutLinesAcross) {
  SolidScene scene(Shape::tubes, {{-1, 0, 0}, {1, 0, 0}}, 1, glm::translate(glm::dmat4(1), {0, 0, -5}));
  scene.instance.impostors.size = {0.1f, 0.1f};
  scene.instance.impostors.centerPlanes = {{1, 0, 0, 0}};
  scene.place();
  const auto meets = [&](float x) {
    return meetSolid(scene.placed, 0, {{x, 0, 3}, {0, 0, -1}, 0, 100}).has_value();
  };
  EXPECT_TRUE(meets(0.5f));
  EXPECT_FALSE(meets(-0.5f));
}

TEST(Solid, AnySizeAndDistance) {
  for (const double scale : {1e-12, 1e-3, 1.0, 1e6, 1e12}) {
    const SolidScene scene(Shape::spheres, {{0, 0, 0}}, static_cast<float>(scale), glm::dmat4(1));
    const auto from = static_cast<float>(1000 * scale);
    const std::optional<SolidHit> hit =
        meetSolid(scene.placed, 0, {{0, 0, from}, {0, 0, -from}, 0, std::numeric_limits<float>::infinity()});
    ASSERT_TRUE(hit) << scale;
    EXPECT_NEAR(hit->t, 0.999f, 1e-6f) << scale;
  }
}

}  // namespace
}  // namespace gluray::accel
