// Colours known at some points of space, asked for at others.
#include "render/paths/space_colors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

const glm::vec3 kRedColor(1, 0, 0), kBlueColor(0, 0, 1);

/// A square of n x n points in the plane z = 0 whose colours change along x.
SpaceColors gradient(int n) {
  SpaceColors colors;
  colors.prepare(glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0), static_cast<size_t>(n * n));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / static_cast<float>(n);
      colors.add({2 * p.x - 1, 2 * p.y - 1, 0}, {p.x, 1 - p.x, 0.5f});
    }
  colors.finish();
  return colors;
}

TEST(SpaceColors, AreThoseOfThePointsAround) {
  const SpaceColors colors = gradient(128);
  for (const float x : {0.1f, 0.4f, 0.77f})
    for (const float z : {0.0f, 0.01f}) {
      const glm::vec3 color = colors.at({2 * x - 1, 0.3f, z});
      EXPECT_NEAR(color.r, x, 0.02f);
      EXPECT_NEAR(color.g, 1 - x, 0.02f);
      EXPECT_NEAR(color.b, 0.5f, 1e-5f);
    }
}

TEST(SpaceColors, AreThoseOfTheNearestPointsWhereNoneIsAround) {
  SpaceColors colors;
  colors.prepare(glm::vec3(0), glm::vec3(8, 1, 1), 1000);
  for (int i = 0; i < 500; ++i) {
    const float at = static_cast<float>(i % 100) / 100;
    colors.add({at, at, 0.5f}, kRedColor), colors.add({7 + at, at, 0.5f}, kBlueColor);
  }
  colors.finish();
  EXPECT_GT(colors.at({2.5f, 0.5f, 0.5f}).r, 0.9f);
  EXPECT_GT(colors.at({5.5f, 0.5f, 0.5f}).b, 0.9f);
  const glm::vec3 between = colors.at({4, 0.5f, 0.5f});
  EXPECT_NEAR(between.r, 0.5f, 0.2f);
  EXPECT_NEAR(between.r + between.b, 1, 1e-4f);
  for (const glm::vec3& far : {glm::vec3(1e30f), glm::vec3(-1e30f, 0, 0)})
    EXPECT_TRUE(std::isfinite(colors.at(far).r));
}

/// No step between two places that are close to each other.
TEST(SpaceColors, ChangeSmoothly) {
  SpaceColors colors;
  colors.prepare(glm::vec3(0), glm::vec3(1), 4096);
  for (int i = 0; i < 4096; ++i) {  // the half x < 0.5 of the face z = 0
    const glm::vec2 p(0.5f * static_cast<float>(i % 64) / 64, static_cast<float>(i / 64) / 64);
    colors.add({p, 0}, p.x < 0.25f ? kRedColor : kBlueColor);
  }
  colors.finish();
  glm::vec3 last = colors.at({0, 0.5f, 0.9f});
  for (int i = 1; i <= 4000; ++i) {
    const glm::vec3 now = colors.at({static_cast<float>(i) / 4000, 0.5f, 0.9f * (1 - float(i) / 4000)});
    EXPECT_LT(glm::length(now - last), 0.08f) << i;
    last = now;
  }
}

TEST(SpaceColors, OfOnePointAndOfNone) {
  SpaceColors colors;
  EXPECT_TRUE(colors.empty());
  colors.prepare(glm::vec3(1), glm::vec3(1), 1);
  colors.add(glm::vec3(1), kBlueColor);
  colors.finish();
  EXPECT_EQ(colors.at(glm::vec3(-5)), kBlueColor);
  colors.prepare(glm::vec3(0), glm::vec3(1), 10);
  colors.finish();
  EXPECT_TRUE(colors.empty());
}

}  // namespace
}  // namespace gluray::render
