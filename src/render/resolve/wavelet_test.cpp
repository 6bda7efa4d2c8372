// The wavelet filter: known answers.
#include "render/resolve/wavelet.h"

#include "base/image.h"
#include "render/testing/noisy_wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gluray::render {
namespace {

using test::addNoise;
using Wall = test::NoisyWall;

double deviation(const std::vector<float>& values, double mean) {
  double sum = 0;
  for (const float v : values) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(Wavelet, ConstantLightStaysConstant) {
  Wall wall;
  wall.each([&](int x, int y, size_t i) {
    for (size_t c = 0; c < 3; ++c)
      wall.reflectance[4 * i + c] = 0.2f + 0.008f * static_cast<float>((x + y) % 90);
    wall.light(i, 0.7f);
  });
  bool changed = false;
  const std::vector<float> out = wall.smooth(true, &changed);
  EXPECT_TRUE(changed);
  for (size_t i = 0; i < out.size(); ++i) ASSERT_NEAR(out[i], wall.color[4 * i], 0.003f) << i;
}

TEST(Wavelet, SmoothsNoise) {
  for (const bool known : {true, false}) {
    Wall wall;
    addNoise(wall);
    EXPECT_LT(deviation(wall.smooth(known), 0.5), 0.015) << known;
  }
}

/// Two halves of different light that meet at column 40; `divide` makes them different surfaces.
template <class Divide>
void expectUncrossed(const char* what, const Divide& divide) {
  Wall wall;
  wall.noise.assign(wall.noise.size(), static_cast<uint16_t>(kNoiseOne));
  wall.each([&](int x, int, size_t i) {
    if (x >= 40) divide(wall, x, i);
    wall.light(i, x < 40 ? 0.2f : 0.8f);
  });
  const std::vector<float> out = wall.smooth();
  wall.each([&](int x, int y, size_t i) {
    ASSERT_NEAR(out[i], wall.color[4 * i], 0.002f) << what << ' ' << x << ' ' << y;
  });
}

TEST(Wavelet, DoesNotCrossEdges) {
  expectUncrossed("depth", [](Wall& wall, int, size_t i) { wall.geometry[4 * i + 3] = 1.05f; });
  expectUncrossed("normal", [](Wall& wall, int x, size_t i) {
    // A wall that goes away to the right, and meets the other one at the edge.
    const float a = std::sqrt(0.5f), beyond = static_cast<float>(x - 40);
    wall.geometry[4 * i] = a, wall.geometry[4 * i + 2] = -1000 * a;
    wall.geometry[4 * i + 3] = 1 / (1 - 1e-3f * beyond);
  });
  expectUncrossed("reflectance", [](Wall& wall, int, size_t i) {
    for (size_t c = 0; c < 3; ++c) wall.reflectance[4 * i + c] = c == 1 ? 0.8f : 1;
  });
  expectUncrossed("nothing there", [](Wall& wall, int, size_t i) { wall.depth[i] = Image::kMiss; });
}

TEST(Wavelet, LevelPlanesThatTiltAreOneSurface) {
  // A plane at 45 degrees to the line of sight: d falls with the column.
  Wall wall;
  const float a = std::sqrt(0.5f);
  wall.each([&](int x, int, size_t i) {
    wall.geometry[4 * i] = a, wall.geometry[4 * i + 2] = -1000 * a;
    wall.geometry[4 * i + 3] = 1 / (1 - 1e-3f * static_cast<float>(x));
  });
  addNoise(wall);
  EXPECT_LT(deviation(wall.smooth(), 0.5), 0.02);
}

TEST(Wavelet, LightThatRisesEvenlyIsSmoothedAsEvenLight) {
  // Over eight pixels light rises by more than five times the noise that two rounds leave.
  const auto deviationOf = [](float slope) {
    Wall wall(160, 96);
    addNoise(wall);
    const std::vector<float> even = wall.color;
    const auto rise = [&](int x) { return slope * static_cast<float>(x); };
    wall.each([&](int x, int, size_t i) { wall.light(i, even[4 * i] + rise(x)); });
    const std::vector<float> out = wall.smooth();
    std::vector<float> rest;
    wall.each([&](int x, int y, size_t i) {
      if (x >= 20 && x < 140 && y >= 20 && y < 76) rest.push_back(out[i] - rise(x));
    });
    return deviation(rest, 0.5);
  };
  const double even = deviationOf(0);
  EXPECT_LT(even, 0.01);
  EXPECT_NEAR(deviationOf(0.02f), even, 0.1 * even);
}

TEST(Wavelet, IsTheIdentityWithoutNoise) {
  Wall wall;
  addNoise(wall);
  wall.noise.assign(wall.noise.size(), 0);
  bool changed = false;
  wall.smooth(true, &changed);
  EXPECT_FALSE(changed);
  wall.noise.assign(wall.noise.size(), static_cast<uint16_t>(0.1f * kNoiseOne));
  wall.target = 0.11f;
  wall.smooth(true, &changed);
  EXPECT_FALSE(changed) << "less noise than the target";
}

TEST(Wavelet, PixelsBelowTheTargetKeepTheirBits) {
  Wall wall(128, 64);
  addNoise(wall);
  wall.target = 0.01f;
  wall.each([&](int x, int, size_t i) {
    if (x >= 64) wall.noise[i] = static_cast<uint16_t>(0.009f * kNoiseOne);
  });
  const std::vector<float> out = wall.smooth();
  int changed = 0;
  wall.each([&](int x, int, size_t i) {
    if (x >= 66) { EXPECT_EQ(out[i], wall.color[4 * i]) << x; }
    changed += x < 60 && out[i] != wall.color[4 * i];
  });
  EXPECT_GT(changed, 3000);
}

TEST(Wavelet, ValuesThatAreNotFiniteDoNotSpread) {
  Wall wall;
  addNoise(wall);
  wall.color[4 * wall.at(20, 20)] = std::nanf("");
  wall.color[4 * wall.at(21, 20) + 1] = std::numeric_limits<float>::infinity();
  wall.geometry[4 * wall.at(40, 30) + 1] = std::nanf("");
  wall.geometry[4 * wall.at(41, 30) + 3] = -std::numeric_limits<float>::infinity();
  wall.reflectance[4 * wall.at(50, 30)] = std::nanf("");
  const std::vector<float> out = wall.smooth();
  wall.each([&](int x, int y, size_t i) {
    if (x != 20 || y != 20) { EXPECT_TRUE(std::isfinite(out[i])) << x << ' ' << y; }
  });
}

TEST(Wavelet, BrightDotsAreNoise) {
  Wall wall;
  addNoise(wall);
  wall.each([&](int x, int y, size_t i) {
    if (x % 16 != 8 || y % 16 != 8) return;
    wall.light(i, 50);
    wall.noise[i] = static_cast<uint16_t>(kNoiseOne);
  });
  wall.most = kBrightest;
  for (const bool known : {true, false}) {
    const std::vector<float> out = wall.smooth(known);
    EXPECT_LT(*std::max_element(out.begin(), out.end()), 0.8f) << known;
  }
}

TEST(Wavelet, LightWithoutNoiseKeepsItsEdges) {
  Wall wall;
  addNoise(wall);
  std::vector<float> edges(wall.color.size(), 0.0f);
  wall.each([&](int x, int y, size_t i) {
    for (size_t c = 0; c < 3; ++c) {
      edges[4 * i + c] = (x / 3 + y / 3) % 2 ? 0.25f : 0.0f;
      wall.color[4 * i + c] += edges[4 * i + c];
    }
  });
  const auto error = [&] {
    std::vector<float> rest = wall.smooth();
    for (size_t i = 0; i < rest.size(); ++i) rest[i] -= edges[4 * i];
    return deviation(rest, 0.5);
  };
  EXPECT_GT(error(), 0.06) << "edges that noise hides are smoothed";
  wall.noiseless.resize(wall.depth.size());
  packReflectances(edges.data(), wall.depth.size(), wall.noiseless.data());
  EXPECT_LT(error(), 0.02);
}

TEST(Wavelet, NoiseDoesNotDarkenWhatIsNearlyWhite) {
  Wall wall;
  addNoise(wall);
  wall.each([&](int, int, size_t i) { wall.light(i, wall.color[4 * i] + 0.48f); });
  wall.most = kBrightest;
  double sum = 0;
  for (const float v : wall.smooth()) sum += v;
  EXPECT_NEAR(sum / static_cast<double>(wall.depth.size()), 0.98, 0.005);
}

/// Two surfaces at different distances that meet in column 70, which shows `share` of the left one.
Wall mixedWall(float share) {
  Wall wall(140, 40);
  wall.packedCoverage.assign(wall.depth.size(), packCoverage(1));
  addNoise(wall);
  wall.each([&](int x, int, size_t i) {
    const float noise = wall.color[4 * i] - 0.5f, left = x < 70 ? 1 : x > 70 ? 0 : share;
    wall.light(i, 0.3f * left + 0.7f * (1 - left) + noise);
    wall.geometry[4 * i + 3] = left + 1.5f * (1 - left);
    if (x == 70) wall.geometry[4 * i + 2] = 1000;
  });
  return wall;
}

TEST(Wavelet, UnmixesPixelsOfTwoSurfaces) {
  for (const float share : {0.25f, 0.5f, 0.9f}) {
    Wall wall = mixedWall(share);
    const std::vector<float> out = wall.smooth();
    wall.each([&](int x, int y, size_t i) {
      const float left = x < 70 ? 1 : x > 70 ? 0 : share;
      if (std::abs(x - 70) <= 2) {
        EXPECT_NEAR(out[i], 0.3f * left + 0.7f * (1 - left), 0.06f) << x << ' ' << y;
      }
    });
  }
}

TEST(Wavelet, PixelsOfAnyCoverageHaveTheLightOfTheirSurface) {
  Wall wall;
  wall.packedCoverage.resize(wall.depth.size());
  addNoise(wall);
  wall.each([&](int x, int, size_t i) {
    const float cover = x == 40 ? 0.25f : x == 41 ? 0.75f : 1;
    wall.packedCoverage[i] = packCoverage(cover);
    for (size_t c = 0; c < 3; ++c) wall.color[4 * i + c] *= cover;
    wall.noise[i] = static_cast<uint16_t>(0.1f * cover * kNoiseOne);
  });
  const std::vector<float> out = wall.smooth();
  wall.each([&](int x, int, size_t i) {
    const float cover = x == 40 ? 0.25f : x == 41 ? 0.75f : 1;
    ASSERT_NEAR(out[i], 0.5f * cover, 0.06f * cover) << x;
  });
}

TEST(Wavelet, TilesDoNotShow) {
  constexpr int kShift = 24;
  Wall wall(180, 70), part(180 - kShift, 70);
  addNoise(wall);
  part.each([&](int x, int y, size_t i) { part.light(i, wall.color[4 * wall.at(x + kShift, y)]); });
  const std::vector<float> whole = wall.smooth(), cut = part.smooth();
  for (int y = 0; y < 70; ++y)
    for (int x = 2 * WaveletTile::kReach; x < part.width; ++x)
      ASSERT_EQ(cut[part.at(x, y)], whole[wall.at(x + kShift, y)]) << x << ' ' << y;
}

}  // namespace
}  // namespace gluray::render
