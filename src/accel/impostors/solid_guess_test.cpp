// Quick answers against exact ones: never another, seldom none.
#include "accel/impostors/solid_guess.h"

#include "accel/impostors/pixel_impostor.h"
#include "accel/impostors/solid.h"
#include "accel/testing/test_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

using scene::Shape;
using test::kInfinity;
constexpr uint32_t kSolids = 40;

/// Evenly spread over [-1, 1].
float spread(uint32_t i, double step) {
  const double x = 0.5 + step * (i + 1);
  return static_cast<float>(2 * (x - std::floor(x)) - 1);
}
glm::vec3 spreadInCube(uint32_t i, double first) {
  return {spread(i, first * 0.754877666), spread(i, first * 0.569840296), spread(i, first * 0.362109)};
}

/// Solids within [-1, 1]^3 `size` times as large, in lighting space five sizes before the viewer.
PlacedImpostors place(Shape shape, double size, const glm::vec3& stretched, bool inPixels) {
  std::vector<glm::vec3> points;
  for (uint32_t i = 0; i < kSolids; ++i) {
    const glm::vec3 center = spreadInCube(i, 1);
    for (uint32_t k = 0; k < scene::cornersOf(shape); ++k)
      points.push_back((center + (k ? 0.5f * spreadInCube(i, 7) : glm::vec3(0))) * static_cast<float>(size));
  }
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = shape, mesh->radius = static_cast<float>(0.1 * size);
  mesh->vertexCount = static_cast<uint32_t>(points.size()), mesh->triangleCount = kSolids;
  mesh->positions = test::makeAttribute(std::move(points), scene::Format::float3);
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = glm::scale(
      glm::rotate(glm::translate(glm::dmat4(1), {0.1 * size, 0.2 * size, -5 * size}), 0.7, {1, 2, 3}),
      glm::dvec3(stretched));
  instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
  instance.impostors.size = {0.05f, 0.05f};
  if (!inPixels) instance.impostors.radius = mesh->radius;
  scene::Camera camera;
  camera.viewport = {0, 0, 200, 200};
  camera.clipFromEye = glm::perspective(glm::radians(60.0), 1.0, 0.1 * size, 100 * size);
  PlacedImpostors placed(instance, camera);
  if (scene::isInWindow(shape)) placed.window = windowVertices(placed);
  return placed;
}

struct Counts {
  int hits = 0, misses = 0, open = 0;
};

/// Asks packets of 16 rays through the solids' cube, from up to `away` sizes away.
Counts compare(const PlacedImpostors& placed, double size, double away) {
  Counts counts;
  for (uint32_t n = 0; n < 1000; ++n) {
    const uint32_t primitive = n % kSolids;
    alignas(64) float rows[9][kLanes];
    for (uint32_t i = 0; i < kLanes; ++i) {
      const uint32_t k = n * kLanes + i;
      // Half of them at the solid.
      const glm::dvec3 to =
          k % 2 ? spreadInCube(k, 3) : spreadInCube(primitive, 1) + 0.3f * spreadInCube(k, 3);
      const glm::dvec3 from = to + away * glm::dvec3(spreadInCube(k, 5));
      const glm::dvec3 dir = (to - from) * (k % 3 ? 1.0 : 1e-3);
      for (int c = 0; c < 3; ++c)
        rows[c][i] = static_cast<float>(size * from[c]), rows[4 + c][i] = static_cast<float>(size * dir[c]);
      rows[3][i] = k % 5 ? 0 : 0.3f, rows[7][i] = 0, rows[8][i] = k % 7 ? kInfinity : 1.1f;
    }
    const std::optional<RoundHull> hull = hullOf(placed, primitive);
    if (!hull) continue;
    const SolidGuess guess = guessSolid(placed, *hull, rows[0], kLanes, 0xBFFF);
    EXPECT_EQ(guess.hits & guess.misses, 0u);
    EXPECT_EQ((guess.hits | guess.misses) & ~0xBFFFu, 0u) << "lanes that were not asked";
    for (uint32_t i = 0; i < kLanes; ++i) {
      if (!(0xBFFF >> i & 1)) continue;
      const ObjectRay ray{
          {rows[0][i], rows[1][i], rows[2][i]}, {rows[4][i], rows[5][i], rows[6][i]}, rows[3][i], rows[8][i]};
      const bool met = meetSolid(placed, primitive, ray).has_value();
      if (guess.hits >> i & 1) {
        EXPECT_TRUE(met) << n << " " << i;
        ++counts.hits;
      } else if (guess.misses >> i & 1) {
        EXPECT_FALSE(met) << n << " " << i;
        ++counts.misses;
      } else {
        ++counts.open;
      }
    }
  }
  return counts;
}

constexpr Shape kShapes[] = {Shape::spheres, Shape::beads, Shape::tubes, Shape::balls, Shape::capsules};

TEST(SolidGuess, IsSeldomOpen) {
  for (const Shape shape : kShapes)
    for (const bool inPixels : {false, true}) {
      const Counts counts = compare(place(shape, 1, glm::vec3(1), inPixels), 1, 2);
      EXPECT_GT(counts.hits, 30) << static_cast<int>(shape);
      EXPECT_LT(counts.open, (counts.hits + counts.misses) / 10) << static_cast<int>(shape);
    }
}

TEST(SolidGuess, IsRightAtAnySizeAndDistance) {
  for (const Shape shape : kShapes)
    for (const double size : {1e-25, 1e-12, 1.0, 1e12, 1e25})
      for (const double away : {0.1, 1e3, 1e5, 1e7})
        compare(place(shape, size, glm::vec3(1), false), size, away);
}

TEST(SolidGuess, IsRightInStretchedSpaces) {
  for (const Shape shape : kShapes)
    for (const glm::vec3 stretched : {glm::vec3(1, 1, 10), glm::vec3(1e-4f, 1, 1), glm::vec3(1, 1e5f, 1e-3f)})
      for (const double away : {0.5, 50.0}) compare(place(shape, 1, stretched, true), 1, away);
}

TEST(SolidGuess, RaysWithoutMeaningStayOpen) {
  const PlacedImpostors placed = place(Shape::capsules, 1, glm::vec3(1), false);
  alignas(64) float rows[9][kLanes] = {};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (uint32_t i = 0; i < kLanes; ++i) rows[6][i] = 1, rows[8][i] = kInfinity;
  rows[0][0] = nan, rows[1][1] = kInfinity, rows[4][2] = nan, rows[6][3] = 0, rows[5][4] = kInfinity;
  const SolidGuess guess = guessSolid(placed, hullOf(placed, 0).value(), rows[0], kLanes, 0x1F);
  EXPECT_EQ(guess.hits, 0u);
  EXPECT_EQ(guess.misses, 0u);
}

}  // namespace
}  // namespace gluray::accel
