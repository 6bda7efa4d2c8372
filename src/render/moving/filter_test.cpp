// The filter of visibility on buffers made by hand.
#include "render/moving/filter.h"

#include "render/testing/test_targets.h"
#include "render/tiles/tile.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>

namespace gluray::render {
namespace {

constexpr int kFilteredSize = 64;  // pixels: four tiles

struct Pixel {
  float depth = 1.5f;
  bool tilted = false;  // its normal is not that of the others
  uint32_t samples = 1;
  float visibility = 0;
};

/// A buffer whose pixels are one unit wide and look along z; a depth of 1 is 100 units.
struct MovingBuffer {
  VisibilityBuffer buffer;
  MovingFrame moving;

  explicit MovingBuffer(const std::function<Pixel(int, int)>& pixelAt) {
    buffer.resize(kFilteredSize, kFilteredSize, 1);
    for (int y = 0; y < kFilteredSize; ++y)
      for (int x = 0; x < kFilteredSize; ++x) put(x, y, pixelAt(x, y));
    moving.visibility = &buffer;
    moving.channels.used.occlusion = true;
    moving.space.usable = true;
    moving.space.baseX = {1, 0, 0}, moving.space.baseY = {0, 1, 0}, moving.space.ray = {0, 0, 100};
    moving.space.pixel = 1;
  }
  void put(int x, int y, const Pixel& p) {
    const uint32_t depth = (std::bit_cast<uint32_t>(p.depth) - 0x30000000u) >> 8;
    const uint32_t normal = p.tilted ? 126u << 7 | 63u : 63u << 7 | 63u;  // +x or +z
    const size_t at = static_cast<size_t>(y * kFilteredSize + x);
    buffer.words[2 * at] = depth << 12 | static_cast<uint32_t>(std::lround(p.visibility * 4095));
    buffer.words[2 * at + 1] = p.samples == 0 ? 0 : normal << 18 | p.samples << 12;
  }
  /// All filtered pixels, row by row.
  std::vector<float> filtered() const {
    std::vector<float> out(kFilteredSize * kFilteredSize);
    for (int y0 = 0; y0 < kFilteredSize; y0 += kTileSize)
      for (int x0 = 0; x0 < kFilteredSize; x0 += kTileSize) {
        TileVisibility tile;
        filterTile(moving, {x0, y0, x0 + kTileSize, y0 + kTileSize}, tile);
        for (int y = 0; y < kTileSize; ++y)
          for (int x = 0; x < kTileSize; ++x) {
            const int lane = (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2;
            out[static_cast<size_t>((y0 + y) * kFilteredSize + x0 + x)] = tile.at(x, y).occlusion[lane];
          }
      }
    return out;
  }
};

/// 0 or 1, as if by chance.
float noise(int x, int y) {
  uint32_t h = static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca77u;
  h = (h ^ h >> 16) * 0x7feb352du, h = (h ^ h >> 15) * 0x846ca68bu;
  return (h ^ h >> 16) & 1 ? 1.0f : 0.0f;
}

/// Mean and variance.
std::pair<double, double> momentsOf(const std::vector<float>& values) {
  double sum = 0, squares = 0;
  for (const float v : values) sum += v, squares += static_cast<double>(v) * v;
  const auto n = static_cast<double>(values.size());
  return {sum / n, squares / n - sum / n * sum / n};
}

TEST(VisibilityFilter, KeepsWhatIsTheSameEverywhere) {
  test::withEachTarget([](int64_t) {
    for (const uint32_t samples : {1u, 16u})
      for (const float v : MovingBuffer([&](int, int) {
                             return Pixel{1.5f, false, samples, 0.25f};
                           }).filtered())
        ASSERT_NEAR(v, 0.25f, 0.0002f);
  });
}

TEST(VisibilityFilter, SeesEachOfSixteenDirectionsOnce) {
  // A pattern that repeats after four pixels both ways becomes its mean, away from the buffer's edges; of few
  // samples and of more, as far as those do not explain the pattern.
  for (const uint32_t samples : {1u, 9u}) {
    const MovingBuffer buffer([&](int x, int y) {
      return Pixel{1.5f, false, samples, 0.4f + ((x * 5 + y * 3) % 4 == 0 ? 0.1f : 0.0f)};
    });
    const std::vector<float> out = buffer.filtered();
    for (int y = 4; y < kFilteredSize - 4; ++y)
      for (int x = 4; x < kFilteredSize - 4; ++x)
        ASSERT_NEAR(out[static_cast<size_t>(y * kFilteredSize + x)], 0.425f, 0.0005f) << samples;
  }
}

TEST(VisibilityFilter, LessensNoiseAsItsWeightsSay) {
  // Sums of squared weights of a row, divided by that of weights, squared: of few samples, and of more.
  const double wide = (7 + 2 * 0.25) / 64, narrow = (3 + 2 * 0.25) / 16;
  for (const auto& [samples, row] : {std::pair{1u, wide}, std::pair{9u, narrow}}) {
    // So little noise that as many samples explain it.
    const MovingBuffer buffer([&, samples = samples](int x, int y) {
      return Pixel{1.5f, false, samples, 0.4f + 0.2f * noise(x, y)};
    });
    const auto [mean, variance] = momentsOf(buffer.filtered());
    EXPECT_NEAR(mean, 0.5, 0.01);
    // At the buffer's edges fewer pixels count.
    EXPECT_NEAR(variance / 0.01, row * row, 0.35 * row * row) << samples;
  }
}

TEST(VisibilityFilter, WithHistoryLooksFarOnlyWhereTheNearestShowTheSameSurface) {
  // Strips two pixels wide at two depths: beyond the nearest neighbour, every strip but one is another
  // surface; farther strips at the same depth are other surfaces of the same look.
  const auto strip = [](int x) { return x / 2; };
  MovingBuffer buffer([&](int x, int) {
    return Pixel{strip(x) % 2 ? 1.6f : 1.2f, false, 1, strip(x) % 4 < 2 ? 0.25f : 0.75f};
  });
  buffer.moving.earlier = &buffer.buffer;
  const std::vector<float> out = buffer.filtered();
  for (int y = 4; y < kFilteredSize - 4; ++y)
    for (int x = 4; x < kFilteredSize - 4; ++x)
      ASSERT_NEAR(out[static_cast<size_t>(y * kFilteredSize + x)], strip(x) % 4 < 2 ? 0.25f : 0.75f, 0.0005f)
          << x;
}

TEST(VisibilityFilter, DoesNotCrossEdges) {
  const auto left = [](int x) { return x < 30; };
  const auto value = [&](int x) { return left(x) ? 0.0f : 1.0f; };
  const MovingBuffer depths([&](int x, int) { return Pixel{left(x) ? 1.2f : 1.6f, false, 1, value(x)}; });
  const MovingBuffer normals([&](int x, int) { return Pixel{1.5f, left(x), 1, value(x)}; });
  const MovingBuffer holes([&](int x, int) { return Pixel{1.5f, false, left(x) ? 0u : 1u, value(x)}; });
  for (const MovingBuffer* buffer : {&depths, &normals, &holes}) {
    const std::vector<float> out = buffer->filtered();
    for (int y = 0; y < kFilteredSize; ++y)
      for (int x = buffer == &holes ? 30 : 0; x < kFilteredSize; ++x)
        ASSERT_NEAR(out[static_cast<size_t>(y * kFilteredSize + x)], value(x), 0.0005f) << x << " " << y;
  }
}

TEST(VisibilityFilter, CrossesSlopes) {
  // 60 units of depth over 64 pixels: one plane, which its normals say.
  MovingBuffer buffer([](int x, int y) {
    return Pixel{1.2f + 0.0001f * static_cast<float>(x), false, 1, noise(x, y)};
  });
  EXPECT_LT(momentsOf(buffer.filtered()).second, 0.25 / 10);
}

TEST(VisibilityFilter, KeepsDetailThatNoiseDoesNotExplain) {
  // One dark line of one pixel, known from many samples.
  const auto at = [](uint32_t samples) {
    const MovingBuffer buffer([&](int x, int) { return Pixel{1.5f, false, samples, x == 20 ? 0.0f : 0.9f}; });
    return buffer.filtered()[10 * kFilteredSize + 20];
  };
  EXPECT_LT(at(16), 0.2f);
  EXPECT_GT(at(1), 0.4f);
}

TEST(VisibilityFilter, ValuesWithMoreSamplesWeighMore) {
  const MovingBuffer buffer([](int x, int) {
    return Pixel{1.5f, false, x == 20 ? 1u : 15u, x == 20 ? 1.0f : 0.0f};
  });
  EXPECT_LT(buffer.filtered()[10 * kFilteredSize + 20], 0.1f);
}

}  // namespace
}  // namespace gluray::render
