// Visible clusters are never skipped, whatever the matrix; invisible ones mostly are; the drawing order is
// kept.
#include "gl/culled/clusters/clusters.h"

#include "base/sanitized.h"
#include "gl/testing/test_images.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace gluray::gl::culling_test {
namespace {

/// The triangles that write() returns, by the position of their first corner in `mesh.indices`.
std::vector<uint32_t> drawn(const TestMesh& mesh, const Clusters& clusters,
                            const std::vector<uint64_t>& visible) {
  std::vector<uint32_t> out(3 * clusters.primitivesIn(visible));
  EXPECT_EQ(clusters.write(visible, mesh.primitives(), out.data()), out.size());
  return out;
}

/// Samples are at pixel centres or, if `anywhere`, at any place in the pixel.
void expectNearerOnesShown(bool anywhere) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> inPixel(0, 1);
  WindowMapping mapping = window();
  mapping.sampleReach = anywhere ? 0.5 : 0;
  uint64_t tested = 0, hidden = 0;
  const unsigned rounds = kSanitized ? 12 : 60;
  for (unsigned round = 0; round < rounds; ++round) {
    const TestMesh mesh =
        sheet(round % 2 ? 40 : 8, 30 + static_cast<int>(random() % 30), round % 2 == 1, random());
    const Primitives p = mesh.primitives();
    const Clusters clusters(p);
    EXPECT_EQ(clusters.areRuns(), round % 2 == 0);
    const glm::dmat4 m = randomView(random);
    const std::vector<float> depths = depthImage(random);
    DepthPyramid pyramid;
    pyramid.build(depths.data(), kWidth, kHeight);
    std::vector<uint64_t> visible;
    clusters.mayShow(clipBy(m), mapping, &pyramid, visible);
    hidden += p.count - clusters.primitivesIn(visible);
    std::vector<std::array<uint32_t, 3>> shown;
    const std::vector<uint32_t> out = drawn(mesh, clusters, visible);
    for (size_t i = 0; i < out.size(); i += 3) shown.push_back({out[i], out[i + 1], out[i + 2]});
    std::ranges::sort(shown);
    for (uint32_t t = 0; t < p.count; ++t) {
      const std::array<uint32_t, 3> corners{p.vertex(t, 0), p.vertex(t, 1), p.vertex(t, 2)};
      if (std::ranges::binary_search(shown, corners)) continue;
      const std::array<glm::dvec4, 3> clip{m * p.position(corners[0]), m * p.position(corners[1]),
                                           m * p.position(corners[2])};
      if (std::ranges::any_of(clip, [](const glm::dvec4& c) { return !(c.w > 0); })) continue;
      const WindowTriangle triangle(clip);
      const auto least = [](double u, double v, double w) {
        return static_cast<int>(std::min({u, v, w, 0.0}));
      };
      const auto& c = triangle.corners;
      for (int y = least(c[0].y, c[1].y, c[2].y); y < kHeight && y <= std::max({c[0].y, c[1].y, c[2].y}); ++y)
        for (int x = least(c[0].x, c[1].x, c[2].x); x < kWidth && x <= std::max({c[0].x, c[1].x, c[2].x});
             ++x) {
          if (x < 0 || y < 0) continue;
          const glm::dvec2 place = anywhere ? glm::dvec2(inPixel(random), inPixel(random)) : glm::dvec2(0.5);
          const std::optional<double> depth = triangle.depthAt(x, y, place);
          if (!depth || *depth < 0 || *depth > 1) continue;
          EXPECT_GT(*depth, double{depths[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)]});
          ++tested;
        }
    }
  }
  EXPECT_GT(tested, 300 * rounds);
  EXPECT_GT(hidden, 150 * rounds);
}

TEST(Clusters, NeverMissWhatIsNearerThanTheImage) { expectNearerOnesShown(false); }

TEST(Clusters, NeverMissSamplesThatAreNearer) { expectNearerOnesShown(true); }

TEST(Clusters, KeepTheOrderOfTheDraw) {
  for (const bool shuffled : {false, true}) {
    const TestMesh mesh = sheet(8, 90, shuffled, 9);
    const Clusters clusters(mesh.primitives());
    std::mt19937 random(4);
    std::vector<uint64_t> visible((clusters.count() + 63) / 64, 0);
    for (uint32_t i = 0; i < clusters.count(); ++i)
      if (random() % 3) visible[i / 64] |= uint64_t{1} << (i & 63);
    const std::vector<uint32_t> out = drawn(mesh, clusters, visible);
    size_t at = 0;  // in the whole draw
    for (size_t i = 0; i < out.size(); i += 3) {
      while (at < mesh.indices.size() && !std::equal(&out[i], &out[i] + 3, &mesh.indices[at])) at += 3;
      ASSERT_LT(at, mesh.indices.size());
      at += 3;
    }
    const std::vector<uint64_t> all((clusters.count() + 63) / 64, ~uint64_t{0});
    std::vector<uint64_t> exactly = all;
    if (clusters.count() % 64) exactly.back() = (uint64_t{1} << clusters.count() % 64) - 1;
    EXPECT_EQ(drawn(mesh, clusters, exactly), mesh.indices);
  }
}

TEST(Clusters, LeaveOutAllBehindAWall) {
  const TestMesh mesh = sheet(8, 8, false, 1);  // each triangle covers pixels
  const Clusters clusters(mesh.primitives());
  const glm::dmat4 m =
      glm::perspective(1.0, 1.3, 0.5, 20.0) * glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -5));
  DepthPyramid near, far;
  const std::vector<float> wall(static_cast<size_t>(kWidth) * kHeight, 0.1f), nothing(wall.size(), 1.0f);
  near.build(wall.data(), kWidth, kHeight), far.build(nothing.data(), kWidth, kHeight);
  std::vector<uint64_t> visible;
  clusters.mayShow(clipBy(m), window(), &near, visible);
  EXPECT_EQ(clusters.primitivesIn(visible), 0u);
  clusters.mayShow(clipBy(m), window(), &far, visible);
  EXPECT_EQ(clusters.primitivesIn(visible), mesh.indices.size() / 3);
  clusters.mayShow(clipBy(glm::translate(glm::dmat4(1), glm::dvec3(50, 0, 0)) * m), window(), &far, visible);
  EXPECT_EQ(clusters.primitivesIn(visible), 0u);
}

TEST(Clusters, AlwaysShowWhatHasNoFinitePositions) {
  TestMesh mesh = sheet(8, 20, false, 1);
  mesh.points[1].x = std::numeric_limits<float>::quiet_NaN();
  const Clusters clusters(mesh.primitives());
  DepthPyramid near;
  const std::vector<float> wall(static_cast<size_t>(kWidth) * kHeight, 0.0f);
  near.build(wall.data(), kWidth, kHeight);
  std::vector<uint64_t> visible;
  clusters.mayShow(clipBy(glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 0.5))), window(), &near, visible);
  EXPECT_TRUE(isSet(visible, 0));
}

/// Positions far from the origin: single precision moves them by pixels.
TEST(Clusters, AllowForTheRoundingOfLargeNumbers) {
  TestMesh mesh = sheet(8, 8, false, 1);
  for (glm::vec3& p : mesh.points) p += glm::vec3(3e5f, 0, 0);
  const Clusters clusters(mesh.primitives());
  const glm::mat4 view = glm::translate(glm::mat4(1), glm::vec3(-3e5f, 0, -4));
  const glm::mat4 clip = glm::perspective(1.0f, 1.3f, 0.5f, 20.0f);
  const glm::dmat4 m = glm::dmat4(clip) * glm::dmat4(view);
  glm::dmat4 magnitudes(0);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      for (int k = 0; k < 4; ++k)
        magnitudes[c][r] += std::abs(double{clip[k][r]}) * std::abs(double{view[c][k]});
  // Depths computed in single precision, one pixel each: none may be missed.
  int tested = 0;
  const Primitives p = mesh.primitives();
  for (uint32_t t = 0; t < p.count; ++t) {
    std::array<glm::dvec4, 3> corners;
    for (uint32_t c = 0; c < 3; ++c)
      corners[c] = glm::dvec4(clip * (view * glm::vec4(p.position(p.vertex(t, c)))));
    const WindowTriangle triangle(corners);
    for (int y = 0; y < kHeight; y += kSanitized ? 12 : 3)
      for (int x = 0; x < kWidth; ++x) {
        const std::optional<double> depth = triangle.depthAt(x, y);
        if (!depth) continue;
        std::vector<float> depths(static_cast<size_t>(kWidth) * kHeight, 0.0f);
        depths[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)] = static_cast<float>(*depth);
        DepthPyramid pyramid;
        pyramid.build(depths.data(), kWidth, kHeight);
        std::vector<uint64_t> visible;
        clusters.mayShow({m, magnitudes}, window(), &pyramid, visible);
        EXPECT_TRUE(isSet(visible, t / Clusters::kPrimitives)) << t;
        ++tested;
      }
  }
  EXPECT_GT(tested, kSanitized ? 20 : 100);
}

TEST(DepthPyramid, IsNeverNearerThanItsPixels) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> depth(0, 1);
  for (const glm::ivec2 size :
       {glm::ivec2(1, 1), glm::ivec2(3, 5), glm::ivec2(64, 64), glm::ivec2(97, 33), glm::ivec2(7, 200)}) {
    std::vector<float> all(static_cast<size_t>(size.x * size.y));
    for (float& d : all) d = depth(random);
    DepthPyramid pyramid;
    pyramid.build(all.data(), size.x, size.y);
    for (int round = 0; round < 300; ++round) {
      const int x0 = static_cast<int>(random() % static_cast<unsigned>(size.x)),
                x1 = x0 + static_cast<int>(random() % 40),
                y0 = static_cast<int>(random() % static_cast<unsigned>(size.y)),
                y1 = y0 + static_cast<int>(random() % 40);
      float most = 0;
      for (int y = y0; y <= std::min(y1, size.y - 1); ++y)
        for (int x = x0; x <= std::min(x1, size.x - 1); ++x)
          most = std::max(most, all[static_cast<size_t>(y * size.x + x)]);
      EXPECT_GE(pyramid.farthest(x0, y0, x1, y1), most);
    }
  }
}

}  // namespace
}  // namespace gluray::gl::culling_test
