// What has grown over samples, against a search of all triangles.
#include "render/edges/grown_triangles.h"

#include "render/edges/edged_triangle.h"
#include "render/testing/edged_scene.h"
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

#include <random>

namespace gluray {
namespace {

using render::EdgedTriangle;
using render::Nearest;

constexpr int kSize = 96;

/// `count` triangles of random sizes in a window of kSize pixels, half of them needles thinner than a pixel.
scene::Snapshot soup(uint32_t seed, uint32_t count, float width) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1, 1);
  test::MeshData data;
  std::vector<uint8_t> flags;
  for (uint32_t t = 0; t < count; ++t) {
    const glm::vec3 a(unit(random), unit(random), 0.9f * unit(random));
    const float size = t % 3 == 0 ? 0.02f : 0.7f, thin = t % 2 ? 1.0f : 1e-4f;
    const glm::vec3 along = size * glm::vec3(unit(random), unit(random), 0.1f * unit(random)),
                    aside = thin * size * glm::vec3(unit(random), unit(random), 0.1f * unit(random));
    for (const glm::vec3& p : {a, a + along, a + 0.5f * along + aside}) {
      data.indices.push_back(static_cast<uint32_t>(data.positions.size()));
      data.positions.push_back(p);
    }
    flags.push_back(static_cast<uint8_t>(random() & 7));
  }
  auto s = test::makeSnapshot({test::makeMesh(data)}, kSize);
  test::paintEdges(s, flags, width);
  return s;
}

struct Growth {
  Growth(scene::Snapshot snapshot, std::vector<glm::dvec2> samples)
      : s(std::move(snapshot)),
        lighting(s.shadings[0]),
        surfaces{render::makeSurface(render::View(s.camera), s.instances[0], lighting, true)},
        depth(render::makeDepthMap(s)),
        positions(std::move(samples)),
        grown({s, surfaces, depth, nullptr, kSize, kSize, positions}) {}

  /// The nearest triangle that covers the position, but did not before it grew; to rounding.
  Nearest search(const glm::dvec2& at) const {
    Nearest best;
    for (uint32_t t = 0; t < surfaces[0].mesh->triangleCount; ++t) {
      const EdgedTriangle triangle(surfaces[0], s.camera, t);
      if (!triangle.covers(at)) continue;
      bool own = true;
      for (const render::HalfPlane& plane : triangle.own())
        own = own && glm::dot(plane.normal, at) >= plane.least + 1e-3;
      const double ndc = triangle.ndcDepth(at);
      const Nearest next{depth.windowDepth(ndc), 0, t};
      if (!own && std::abs(ndc) <= 1 && render::isSeenBefore(s, next, best)) best = next;
    }
    return best;
  }

  const scene::Snapshot s;
  render::Lighting lighting;
  std::vector<render::Surface> surfaces;
  render::DepthMap depth;
  std::vector<glm::dvec2> positions;
  render::GrownTriangles grown;
};

TEST(GrownTriangles, AreThoseThatASearchOfAllFinds) {
  int found = 0;
  for (const uint32_t seed : {1u, 2u, 3u})
    for (const float width : {1.0f, 3.0f, 12.0f}) {
      const Growth growth(soup(seed, 60, width), {{0.5, 0.5}, {0.1, 0.8}});
      for (int y0 = 0; y0 < kSize; y0 += render::kTileSize)
        for (int x0 = 0; x0 < kSize; x0 += render::kTileSize) {
          const render::Tile tile{x0, y0, x0 + render::kTileSize, y0 + render::kTileSize};
          render::GrownSamples samples(&growth.grown, tile, 1);
          for (int sample = 0; sample < 2; ++sample) {
            samples.find(sample);
            for (int y = tile.y0; y < tile.y1; ++y)
              for (int x = tile.x0; x < tile.x1; ++x) {
                const glm::dvec2 at = glm::dvec2(x, y) + growth.positions[static_cast<size_t>(sample)];
                const Nearest expected = growth.search(at), got = samples.at(sample, x, y);
                found += expected.instance != accel::kNoHit;
                ASSERT_EQ(got.instance, expected.instance) << at.x << ", " << at.y << ", seed " << seed;
                ASSERT_EQ(got.primitive, expected.primitive) << at.x << ", " << at.y << ", seed " << seed;
              }
          }
        }
    }
  EXPECT_GT(found, 1000);
}

// It lies beside the pixels' centres, so that rays miss it; its edges make it about a pixel wide.
TEST(GrownTriangles, ANeedleIsSeenAllAlong) {
  auto s = soup(1, 0, 4);
  test::MeshData data;
  data.positions = {{-0.8f, 0.0107f, 0}, {0.8f, 0.0107f, 0}, {0.8f, 0.0108f, 0}, {-0.8f, 0.0108f, 0}};
  data.indices = {0, 1, 2, 0, 2, 3};
  s.instances[0].mesh = test::makeMesh(data);
  s.instances[0].triangleEdges = test::makeAttribute(std::vector<uint8_t>{3, 6}, scene::Format::bits8);
  s.instances[0].materials[0].front.ambient = glm::vec4(0);
  const auto traced = test::trace(s);
  for (int x = 12; x < kSize - 12; ++x) EXPECT_TRUE(traced.hit(x, kSize / 2)) << x;
  for (int x = 0; x < kSize; ++x) EXPECT_FALSE(traced.hit(x, kSize / 2 + 3)) << x;
}

}  // namespace
}  // namespace gluray
