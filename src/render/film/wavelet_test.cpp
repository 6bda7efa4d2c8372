// The wavelet filter: known answers.
#include "render/film/wavelet.h"

#include "base/image.h"
#include "render/film/guide_pixels.h"
#include "render/testing/test_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace gluray::render {
namespace {

/// A picture of a wall that faces the viewer, white, of light 0.5 with a standard error of 0.1.
struct Wall {
  int width, height;
  std::vector<float> color, reflectance, geometry, depth;
  std::vector<uint16_t> noise;
  std::vector<uint32_t> packedReflectance, normal;
  std::vector<uint16_t> facing;
  std::vector<float> distance;
  float target = 0, most = std::numeric_limits<float>::max();

  explicit Wall(int w = 80, int h = 70) : width(w), height(h) {
    const size_t n = static_cast<size_t>(w) * static_cast<size_t>(h);
    color.assign(4 * n, 0.5f), reflectance.assign(4 * n, 1), depth.assign(n, 0.5f);
    noise.assign(n, static_cast<uint16_t>(0.1f * kNoiseOne));
    for (size_t i = 0; i < n; ++i) geometry.insert(geometry.end(), {0, 0, -1000, 1});
  }
  size_t at(int x, int y) const { return static_cast<size_t>(y * width + x); }
  /// Calls set(x, y, pixel) for all pixels.
  template <class Set>
  void each(const Set& set) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) set(x, y, at(x, y));
  }
  void light(size_t pixel, float light) {
    for (size_t c = 0; c < 3; ++c) color[4 * pixel + c] = light * reflectance[4 * pixel + c];
  }
  NoisyPicture picture(bool knowsNoise) {
    const size_t n = depth.size();
    packedReflectance.resize(n), normal.resize(n), facing.resize(n), distance.resize(n);
    packGuides(reflectance.data(), n, packedReflectance.data());
    packGeometry(geometry.data(), depth.data(), n, normal.data(), facing.data(), distance.data());
    return {width,
            height,
            color.data(),
            knowsNoise ? noise.data() : nullptr,
            {packedReflectance.data(), normal.data(), facing.data(), distance.data()},
            target,
            most};
  }
  /// The smoothed picture's reds; `changed` tells whether any tile was smoothed.
  std::vector<float> smooth(bool knowsNoise = true, bool* changed = nullptr) {
    const NoisyPicture in = picture(knowsNoise);
    std::vector<float> memory(waveletFloats()), tile(3 * WaveletTile::kSize * WaveletTile::kSize), out;
    for (size_t i = 0; i < depth.size(); ++i) out.push_back(color[4 * i]);
    for (int y = 0; y < height; y += WaveletTile::kSize)
      for (int x = 0; x < width; x += WaveletTile::kSize) {
        const bool did = smoothTile(in, {x, y}, memory.data(), tile.data());
        if (changed) *changed |= did;
        for (int j = 0; did && j < WaveletTile::kSize && y + j < height; ++j)
          for (int i = 0; i < WaveletTile::kSize && x + i < width; ++i)
            out[at(x + i, y + j)] = tile[static_cast<size_t>(3 * (j * WaveletTile::kSize + i))];
      }
    return out;
  }
};

void addNoise(Wall& wall) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal(0.5f, 0.1f);
  wall.each([&](int, int, size_t i) { wall.light(i, normal(random)); });
}

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
    wall.noise[i] = static_cast<uint16_t>(0.7f * kNoiseOne);
  });
  wall.most = 1;
  const std::vector<float> out = wall.smooth();
  EXPECT_LT(*std::max_element(out.begin(), out.end()), 0.7f);
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

/// The filter once more, pixel by pixel, from its definition.
class PlainFilter {
 public:
  explicit PlainFilter(const NoisyPicture& in) : in_(in), pixels_(static_cast<size_t>(in.width * in.height)) {
    for (size_t i = 0; i < pixels_.size(); ++i) unpack(i);
  }
  std::vector<float> smooth() {
    smoothVariances();
    const std::vector<Pixel> before = pixels_;
    for (int step = 1; step <= 8; step *= 2) round(step);
    std::vector<float> out;
    for (size_t i = 0; i < pixels_.size(); ++i) {
      const glm::dvec3 r = before[i].reflectance;
      const double scale = std::max({r.x, r.y, r.z}), square = before[i].variance * scale * scale;
      const double share =
          before[i].shows && square > 0 ? std::max(1 - in_.target * in_.target / square, 0.0) : 0;
      const double own = in_.color[4 * i];
      out.push_back(static_cast<float>(own + (share > 0 ? share * (pixels_[i].light.x * r.x - own) : 0)));
    }
    return out;
  }

 private:
  struct Pixel {
    bool shows = false;
    glm::dvec3 reflectance{0}, light{0}, normal{0};
    double facing = 0, distance = 0, variance = 0;
  };
  void unpack(size_t i) {
    Pixel& p = pixels_[i];
    p.distance = in_.guides.distance[i], p.shows = p.distance > 0;
    if (!p.shows) return;
    p.reflectance = unpackReflectance(in_.guides.reflectance[i]),
    p.facing = unpackFacing(in_.guides.facing[i]);
    const glm::dvec2 n = unpackNormal2(in_.guides.normal[i]);
    p.normal = {n, std::sqrt(std::max(1 - glm::dot(n, n), 0.0))};
    for (int c = 0; c < 3; ++c) p.light[c] = in_.color[4 * i + static_cast<size_t>(c)] / p.reflectance[c];
    const double error = in_.noise[i] / double{kNoiseOne};
    p.variance = std::pow(error / std::max({p.reflectance.x, p.reflectance.y, p.reflectance.z}), 2);
  }
  static double biweight(double x) { return x < 1 ? (1 - x) * (1 - x) : 0; }
  static double luminance(const Pixel& p) { return glm::dot(p.light, glm::dvec3(0.2126, 0.7152, 0.0722)); }
  static double likeness(const Pixel& p, const Pixel& q, int dx, int dy) {
    if (!p.shows || !q.shows) return 0;
    const double off = p.normal.x * dx + p.normal.y * dy + p.facing * (1 - p.distance / q.distance);
    if (std::abs(off) > 0.5 + 0.06 * std::max(std::abs(dx), std::abs(dy))) return 0;
    const glm::dvec3 d = glm::abs(p.reflectance - q.reflectance);
    return std::pow(std::clamp(glm::dot(p.normal, q.normal), 0.0, 1.0), 32) *
           biweight(std::pow(std::max({d.x, d.y, d.z}) / 0.1, 2));
  }
  /// Calls each(neighbour, kernel, likeness) for the neighbours that are inside.
  template <class Each>
  void around(size_t i, int step, const Each& each) const {
    constexpr double kernel[] = {1.0 / 16, 1.0 / 4, 3.0 / 8, 1.0 / 4, 1.0 / 16};
    const int x = static_cast<int>(i) % in_.width, y = static_cast<int>(i) / in_.width;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const int u = x + dx * step, v = y + dy * step;
        if (u < 0 || v < 0 || u >= in_.width || v >= in_.height) continue;
        const Pixel& q = pixels_[static_cast<size_t>(v * in_.width + u)];
        each(q, kernel[dx + 2] * kernel[dy + 2], likeness(pixels_[i], q, dx * step, dy * step));
      }
  }
  void smoothVariances() {
    std::vector<Pixel> next = pixels_;
    for (size_t i = 0; i < pixels_.size(); ++i) {
      double weights = 0, sum = 0;
      around(i, 1, [&](const Pixel& q, double, double w) { weights += w, sum += w * q.variance; });
      next[i].variance = weights > 0 ? sum / weights : 0;
    }
    pixels_ = next;
  }
  void round(int step) {
    std::vector<Pixel> next = pixels_;
    for (size_t i = 0; i < pixels_.size(); ++i) {
      const Pixel& p = pixels_[i];
      double weights = 0, variance = 0;
      glm::dvec3 light(0);
      around(i, step, [&](const Pixel& q, double kernel, double same) {
        const double d = luminance(q) - luminance(p),
                     w = kernel * same * biweight(d * d / (50 * p.variance + 1e-12));
        weights += w, light += w * q.light, variance += w * w * q.variance;
      });
      if (weights > 0) next[i].light = light / weights, next[i].variance = variance / (weights * weights);
    }
    pixels_ = next;
  }

  const NoisyPicture& in_;
  std::vector<Pixel> pixels_;
};

TEST(Wavelet, IsWhatItsDefinitionSays) {
  Wall wall(100, 72);
  addNoise(wall);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(0, 1);
  wall.target = 0.05f;
  wall.each([&](int x, int y, size_t i) {
    const float bend = 0.004f * static_cast<float>(x), light = wall.color[4 * i];
    const float geometry[] = {bend, 0.2f, -1000,
                              1 + 1e-5f * static_cast<float>(x * x) + 2e-4f * static_cast<float>(y)};
    std::copy_n(geometry, 4, &wall.geometry[4 * i]);
    for (size_t c = 0; c < 3; ++c)
      wall.reflectance[4 * i + c] = 0.5f + (x > 50 ? 0.3f : 0) + 0.05f * any(random);
    wall.light(i, light);
    wall.noise[i] = static_cast<uint16_t>(any(random) * 0.2f * kNoiseOne);
    if ((x - 30) * (x - 30) + (y - 30) * (y - 30) < 50) wall.depth[i] = Image::kMiss;
  });
  const NoisyPicture in = wall.picture(true);
  const std::vector<float> expected = PlainFilter(in).smooth();
  test::withEachTarget([&](int64_t target) {
    const std::vector<float> out = wall.smooth();
    // Rounding decides whether a neighbour at the very end of a plane's reach counts.
    int differing = 0;
    for (size_t i = 0; i < out.size(); ++i) {
      ASSERT_NEAR(out[i], expected[i], 5e-3f) << i << " of " << target;
      differing += std::abs(out[i] - expected[i]) > 1e-4f;
    }
    EXPECT_LE(differing, static_cast<int>(out.size() / 100)) << target;
  });
}

}  // namespace
}  // namespace gluray::render
