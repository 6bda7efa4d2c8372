// Exposure and tone curves against their published equations.
#include "render/resolve/tone.h"

#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

double decoded(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double encoded(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

double aces(double x) {
  x *= 0.6;
  return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

double hable(double x) {
  const double a = 0.15, b = 0.5, c = 0.1, d = 0.2, e = 0.02, f = 0.3;
  return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
}

glm::dvec3 expected(Tone tone, const glm::dvec3& linear) {
  const double luminance = glm::dot(linear, glm::dvec3(0.2126, 0.7152, 0.0722));
  switch (tone) {
    case Tone::none: return linear;
    case Tone::reinhard: return linear / (1 + luminance);
    case Tone::aces: return {aces(linear.x), aces(linear.y), aces(linear.z)};
    case Tone::filmic:
      return glm::dvec3(hable(2 * linear.x), hable(2 * linear.y), hable(2 * linear.z)) / hable(11.2);
    case Tone::shoulder: {
      const double most = std::max({linear.x, linear.y, linear.z});
      return most <= 0.6 ? linear : linear * ((0.6 + 0.4 * (1 - std::exp((0.6 - most) / 0.4))) / most);
    }
  }
  return {};
}

TEST(ToneMap, IsItsEquation) {
  test::withEachTarget([](int64_t) {
    for (const Tone tone : {Tone::none, Tone::reinhard, Tone::aces, Tone::filmic, Tone::shoulder}) {
      for (const float exposure : {0.25f, 1.0f, 8.0f}) {
        for (const bool sRgb : {false, true}) {
          ColorRows rows{};
          for (int i = 0; i < kLanes; ++i)
            for (int c = 0; c < 3; ++c)
              rows.value[c][i] = 0.11f * static_cast<float>(i) * static_cast<float>(c + 1);
          const ColorRows before = rows;
          ToneMap{exposure, tone, sRgb}.apply(rows);
          for (int i = 0; i < kLanes; ++i) {
            glm::dvec3 linear;
            for (int c = 0; c < 3; ++c) {
              const double v = before.value[c][i];
              linear[c] = double{exposure} * (sRgb ? decoded(v) : v);
            }
            const glm::dvec3 mapped = expected(tone, linear);
            for (int c = 0; c < 3; ++c) {
              const double want = sRgb ? encoded(mapped[c]) : mapped[c];
              ASSERT_NEAR(rows.value[c][i], want, 2e-5 * std::max(1.0, want)) << static_cast<int>(tone);
            }
          }
        }
      }
    }
  });
}

TEST(ToneMap, KeepsBlackAndTakesAnyNumber) {
  for (const Tone tone : {Tone::none, Tone::reinhard, Tone::aces, Tone::filmic, Tone::shoulder}) {
    ColorRows rows{};
    rows.value[0][1] = std::numeric_limits<float>::quiet_NaN();
    rows.value[0][2] = std::numeric_limits<float>::infinity();
    rows.value[0][3] = -1;
    rows.value[0][4] = 3e38f;
    ToneMap{std::exp2(32.0f), tone, true}.apply(rows);
    for (int i = 0; i < kLanes; ++i)
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(rows.value[c][i]) && rows.value[c][i] > -1e-6f);
    EXPECT_NEAR(rows.value[0][0], 0, 1e-6);
    EXPECT_NEAR(rows.value[0][1], 0, 1e-6);
  }
}

TEST(ToneMap, AStopDoublesLight) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.instances[0].color = {0.5f, 0.2f, 0.9f, 1};
  s.settings.exposure = 1;
  const glm::vec4 color = test::trace(s).color(4, 4);
  EXPECT_NEAR(color.r, std::round(255 * encoded(2 * decoded(0.5))), 1);
  EXPECT_NEAR(color.g, std::round(255 * encoded(2 * decoded(0.2))), 1);
  EXPECT_EQ(color.b, 255);
  s.wideColors = s.encodes = true;  // linear, as the real OpenGL encodes them
  EXPECT_NEAR(test::trace(s).image.wideColor[0], 1.0f, 1e-5);
}

TEST(ToneMap, IsOffByDefault) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  EXPECT_FALSE(makeToneMap(s));
  s.settings.exposure = 1;
  EXPECT_TRUE(makeToneMap(s));
  s.settings.look = Look::honest;
  EXPECT_FALSE(makeToneMap(s));
}

TEST(ToneMap, ReachesMultisampledAndAveragedImages) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.instances[0].color = {0.5f, 0.2f, 0.9f, 1};
  s.settings.exposure = 1;
  const uint32_t plain = test::trace(s).image.color[20];
  s.settings.spp = 4;
  EXPECT_EQ(test::trace(s).image.color[20], plain);
  s.samples = 2;
  s.samplePositions = {{0.25f, 0.25f}, {0.75f, 0.75f}};
  EXPECT_EQ(test::trace(s).image.color[20], plain);
}

}  // namespace
}  // namespace gluray::render
