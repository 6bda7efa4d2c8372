// Shadows against scenes whose edges and penumbrae are known in closed form.
#include "base/sanitized.h"
#include "render/testing/shadow_shares.h"
#include "render/testing/test_targets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace gluray::render {
namespace {

using test::kFromTheRight;
using test::kLitSize;
using test::screened;
using test::Shader;
using test::sharesOf;
using test::Traced;

TEST(Shadows, OfAScreenEndWhereTheLightPassesItsEdge) {
  for (const Shader shader : {Shader::fixedFunction, Shader::phong, Shader::pbr}) {
    const std::vector<float> shares = sharesOf(screened(shader));
    for (int x = 0; x < kLitSize; ++x) {
      const float at = test::wallAt(x);
      if (std::abs(at - 0.6f) < 1e-4f) continue;
      // VTK's physically based shading never sees a cosine of 0.
      EXPECT_EQ(shares[static_cast<size_t>(x)], at < 0.6f ? 1 : 0) << x << " " << static_cast<int>(shader);
    }
  }
}

TEST(Shadows, OfAPointLightFollowItsRays) {
  // From (4, 0, 4) past the screen's edge at (1.6, 0, 1) to x = 0.8 on the wall.
  for (const Shader shader : {Shader::fixedFunction, Shader::phong}) {
    const std::vector<float> shares = sharesOf(screened(shader, {4, 0, -1, 1}));
    for (int x = 0; x < kLitSize; ++x)
      EXPECT_EQ(shares[static_cast<size_t>(x)], test::wallAt(x) < 0.8f ? 1 : 0) << x;
  }
}

/// The visible share of a light of this width, by plain sampling of its directions.
float penumbra(float x, double degrees) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0, 1);
  const double least = std::cos(glm::radians(degrees / 2));
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 0, 1)), a(0, 1, 0), b = glm::cross(axis, a);
  double seen = 0, all = 0;
  for (int i = 0; i < 20000; ++i) {
    const double z = 1 - number(random) * (1 - least), angle = 2 * M_PI * number(random);
    const double r = std::sqrt(1 - z * z);
    const glm::dvec3 w = z * axis + r * (std::cos(angle) * a + std::sin(angle) * b);
    all += w.z;
    if (x + w.x / w.z < 1.6) seen += w.z;
  }
  return static_cast<float>(seen / all);
}

TEST(Shadows, HavePenumbraeAsWideAsTheLightAppears) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  s.settings.shadows.size = 20;
  s.settings.shadows.samples = 256;
  const std::vector<float> shares = sharesOf(s);
  for (int x = 0; x < kLitSize; ++x) {
    const float wanted = penumbra(test::wallAt(x), 20);
    EXPECT_NEAR(shares[static_cast<size_t>(x)], wanted, 0.025f) << x;
  }
  // From 1.6 - tan(55) to 1.6 - tan(35).
  EXPECT_LT(penumbra(0.2f, 20), 1);
  EXPECT_GT(penumbra(0.87f, 20), 0);
  EXPECT_EQ(penumbra(0.15f, 20) - penumbra(0.92f, 20), 1);
}

TEST(Shadows, ConvergeAsTheSquareRootOfTheirSamplesOrFaster) {
  GLURAY_RELEASE_ONLY();
  const auto errorOf = [](int samples) {
    scene::Snapshot s = screened(Shader::fixedFunction);
    s.settings.shadows.size = 20, s.settings.shadows.samples = samples;
    double sum = 0;
    for (const int row : {3, 17, 31, 50}) {
      const std::vector<float> shares = sharesOf(s, 1, row);
      for (int x = 25; x < 60; ++x) {
        const double e = shares[static_cast<size_t>(x)] - penumbra(test::wallAt(x), 20);
        sum += e * e;
      }
    }
    return std::sqrt(sum / (4 * 35));
  };
  const double few = errorOf(4), more = errorOf(64);
  EXPECT_LT(more, few / 4);
  EXPECT_GT(few, 0.02) << "there is noise to converge";
}

TEST(Shadows, OfMoreThanFourLightsAreThoseOfTheStrongest) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  scene::Light light = s.shadings[0].lights[0];
  s.shadings[0].lights.clear();
  for (int i = 0; i < 6; ++i) {
    light.diffuse = {0.02f * static_cast<float>(i + 1), 0.02f * static_cast<float>(i + 1), 0, 1};
    light.position = {1, 0.02f * static_cast<float>(i), 1, 0};
    s.shadings[0].lights.push_back(light);
  }
  // The first two, of 0.02 and 0.04, are not shadowed.
  EXPECT_NEAR(test::trace(s).color(60, 32).g, 255 * 0.06f * 0.7071f, 1);
}

TEST(Shadows, TakeAsMuchAsTheirStrength) {
  scene::Snapshot s = screened(Shader::phong);
  s.settings.shadows.strength = 0.25f;
  EXPECT_NEAR(sharesOf(s)[60], 0.75f, 0.005f);
  s.settings.shadows.strength = 0;
  EXPECT_EQ(sharesOf(s)[60], 1);
}

TEST(Shadows, LeaveAmbientLight) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  s.shadings[0].globalAmbient = {0.1f, 0.1f, 0.1f, 1};
  s.shadings[0].lights[0].ambient = {0.1f, 0.2f, 0.3f, 1};
  for (scene::Instance& i : s.instances) i.materials[0].front.ambient = glm::vec4(1);
  const glm::vec4 dark = test::trace(s).color(60, 10);
  EXPECT_LE(test::difference(dark, glm::vec4(0.2f, 0.3f, 0.4f, 1) * 255.0f), 1);
}

TEST(Shadows, OfOneLightLeaveTheOther) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  scene::Light other = s.shadings[0].lights[0];
  other.position = {-1, 0, 1, 0}, other.diffuse = {0, 0.5f, 0, 1};
  s.shadings[0].lights.push_back(other);
  const glm::vec4 dark = test::trace(s).color(60, 10);
  EXPECT_LE(test::difference(dark, glm::vec4(0, 0.35355f, 0, 1) * 255.0f), 1);
}

/// The wall and the screen, their world scaled while eye space stays the same.
TEST(Shadows, AreTheSameHoweverTheWorldIsScaled) {
  for (const glm::dvec3& scale :
       {glm::dvec3(1, 1, 10), glm::dvec3(100, 1, 0.01), glm::dvec3(1e-6), glm::dvec3(1e6)}) {
    const glm::vec3 inverse(1.0 / scale);
    const auto piece = [&](glm::vec3 c, glm::vec3 a, glm::vec3 b) {
      return test::parallelogram(c * inverse, a * inverse, b * inverse);
    };
    scene::Snapshot s = test::litView(
        {piece({0, 0, 0}, {50, 0, 0}, {0, 50, 0}), piece({11.6f, 0, 1}, {10, 0, 0}, {0, 50, 0})},
        Shader::phong, kFromTheRight);
    s.eyeFromWorld = s.eyeFromWorld * glm::scale(glm::dmat4(1), scale);
    for (scene::Instance& instance : s.instances) {
      instance.eyeFromObject = s.eyeFromWorld;
      instance.lightingFromObject = glm::mat4(s.eyeFromWorld);
    }
    const std::vector<float> shares = sharesOf(s);
    for (int x = 0; x < kLitSize; ++x)
      if (std::abs(test::wallAt(x) - 0.6f) > 1e-3f) {
        EXPECT_EQ(shares[static_cast<size_t>(x)], test::wallAt(x) < 0.6f ? 1 : 0) << scale.x << " " << x;
      }
  }
}

TEST(Shadows, OfScenesOfAnySize) {
  for (const double size : {1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e9}) {
    const auto sized = [&](glm::vec3 v) { return v * static_cast<float>(size); };
    scene::Snapshot s = test::litView(
        {test::parallelogram({0, 0, 0}, sized({50, 0, 0}), sized({0, 50, 0})),
         test::parallelogram(sized({11.6f, 0, 1}), sized({10, 0, 0}), sized({0, 50, 0}))},
        Shader::fixedFunction, {static_cast<float>(4 * size), 0, static_cast<float>(-1 * size), 1});
    s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1 * size, 1000.0 * size);
    s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5 * size});
    for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
    const std::vector<float> shares = sharesOf(s);
    for (int x = 0; x < kLitSize; ++x)
      if (std::abs(test::wallAt(x) - 0.8f) > 1e-3f) {
        EXPECT_EQ(shares[static_cast<size_t>(x)], test::wallAt(x) < 0.8f ? 1 : 0) << size << " " << x;
      }
  }
}

TEST(Shadows, AreTheSameForAnyNumberOfThreadsAndNearlyForAnyInstructionSet) {
  scene::Snapshot s = screened(Shader::phong);
  s.settings.shadows.size = 20, s.settings.shadows.samples = 4;
  const Traced one = test::trace(s);
  s.settings.threads = 4;
  EXPECT_EQ(one.image.color, test::trace(s).image.color);
  test::withEachTarget([&](int64_t) {
    const Traced other = test::trace(s);
    double sum = 0;
    for (int x = 0; x < kLitSize; ++x) sum += std::abs(other.color(x, 20).g - one.color(x, 20).g);
    EXPECT_LT(sum / kLitSize, 2);
  });
}

TEST(Shadows, MultisampledAndAveragedImagesHaveThem) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  s.settings.spp = 4;
  EXPECT_EQ(test::trace(s).color(60, 10).g, 0);
  s.settings.spp = 1, s.samples = 4;
  s.samplePositions = {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};
  EXPECT_EQ(test::trace(s).color(60, 10).g, 0);
  EXPECT_NEAR(test::trace(s).color(4, 10).g, 180, 1);
}

TEST(Shadows, AreKeptApartFromOcclusionOfAmbientLight) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  s.shadings[0].globalAmbient = {0.2f, 0.2f, 0.2f, 1};
  for (scene::Instance& i : s.instances) i.materials[0].front.ambient = glm::vec4(1);
  s.settings.ao.enabled = true, s.settings.ao.on = AmbientOcclusionOn::ambient;
  s.settings.ao.samples = 64, s.settings.ao.radius = 1e6f;
  const Traced both = test::trace(s);
  s.settings.shadows.enabled = false;
  const Traced occluded = test::trace(s);
  // Where the light arrives both are the same; in the shadow only ambient light is left.
  EXPECT_EQ(both.color(4, 30), occluded.color(4, 30));
  EXPECT_NEAR(occluded.color(60, 30).g - both.color(60, 30).g, 180, 2);
  EXPECT_GT(both.color(60, 30).g, 5);
}

}  // namespace
}  // namespace gluray::render
