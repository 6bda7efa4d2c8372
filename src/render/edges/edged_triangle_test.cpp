// Triangles that grow by their painted edges.
#include "render/edges/edged_triangle.h"

#include "render/testing/edged_scene.h"
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using render::EdgedTriangle;
using D2 = glm::dvec2;

/// The square [-0.5, 0.5]^2, which is [16, 48]^2 in a window of 64 x 64 pixels, as two triangles with edges.
/// `slope`: change of window depth along x.
scene::Snapshot square(float width, uint8_t flags0, uint8_t flags1, float slope = 0) {
  test::MeshData data = test::quadData({-0.5f, -0.5f, 0.5f * slope}, {0.5f, -0.5f, -0.5f * slope},
                                       {0.5f, 0.5f, -0.5f * slope}, {-0.5f, 0.5f, 0.5f * slope});
  auto s = test::makeSnapshot({test::makeMesh(data)}, 64);
  scene::Instance& instance = s.instances[0];
  instance.materials[0].front.diffuse = instance.materials[0].back.diffuse = glm::vec4(1);
  instance.materials[0].front.ambient = instance.materials[0].back.ambient = glm::vec4(0);
  test::paintEdges(s, {flags0, flags1}, width);
  return s;
}

struct Stage {
  explicit Stage(const scene::Snapshot& snapshot)
      : s(snapshot),
        lighting(s.shadings[0]),
        surface(render::makeSurface(render::View(s.camera), s.instances[0], lighting, true)) {}
  EdgedTriangle triangle(uint32_t i) const { return {surface, s.camera, i}; }
  const scene::Snapshot s;
  render::Lighting lighting;
  render::Surface surface;
};

// The first triangle has the corners (16, 16), (48, 16), (48, 48), all its edges painted.
TEST(EdgedTriangle, GrowsByAQuarterOfTheWidthAtEachCorner) {
  const Stage stage(square(4, 7, 7));
  const EdgedTriangle t = stage.triangle(0);
  EXPECT_TRUE(t.covers({40, 20}));
  // At the right-angled corner both edges move outwards by one pixel times the cosine of half the angle
  // between their normals.
  const double moved = std::sqrt(0.5);
  EXPECT_TRUE(t.covers({48 + moved - 0.01, 16 - moved + 0.01}));
  EXPECT_FALSE(t.covers({48 + moved + 0.01, 16 - moved + 0.01}));
  EXPECT_FALSE(t.covers({30, 14.9}));
}

TEST(EdgedTriangle, GrowthMayBeOff) {
  scene::Snapshot still = square(4, 7, 7);
  still.shadings[0].fragment.edgesGrow = false;
  const Stage stage(still);
  const EdgedTriangle t = stage.triangle(0);
  EXPECT_TRUE(t.covers({47.99, 16.01}));
  EXPECT_FALSE(t.covers({48.01, 16.01}));
  EXPECT_FALSE(t.covers({30, 15.99}));
  EXPECT_FLOAT_EQ(t.edgeShare({30, 18}), 0.5f) << "painted as wide as ever within";
}

TEST(EdgedTriangle, OpacityIsTheLargestWeight) {
  scene::Snapshot faint = square(4, 7, 7);
  faint.shadings[0].fragment.edgeOpacity = 0.25f;
  const Stage stage(faint);
  EXPECT_FLOAT_EQ(stage.triangle(0).edgeShare({30, 16}), 0.25f);
  EXPECT_FLOAT_EQ(stage.triangle(0).edgeShare({30, 18}), 0.125f);
}

TEST(EdgedTriangle, UnpaintedEdgesKeepHalfAPixel) {
  const Stage painted(square(8, 7, 7)), hidden(square(8, 3, 7));
  const D2 beyondDiagonal = D2(32, 32) + 0.7 * std::sqrt(0.5) * D2(-1, 1);
  EXPECT_TRUE(painted.triangle(0).covers(beyondDiagonal));
  EXPECT_FALSE(hidden.triangle(0).covers(beyondDiagonal));
  EXPECT_TRUE(hidden.triangle(0).covers(D2(32, 32) + 0.4 * std::sqrt(0.5) * D2(-1, 1)));
}

TEST(EdgedTriangle, WeightFallsWithTheDistance) {
  const Stage stage(square(2, 7, 7));
  const EdgedTriangle t = stage.triangle(0);
  EXPECT_FLOAT_EQ(t.edgeShare({40, 16}), 1);
  EXPECT_FLOAT_EQ(t.edgeShare({40, 17}), 0.5f);
  EXPECT_FLOAT_EQ(t.edgeShare({40, 17.25}), 0.25f);
  EXPECT_FLOAT_EQ(t.edgeShare({40, 18}), 0);
  EXPECT_FLOAT_EQ(t.edgeShare({40, 15.5}), 1);
  const Stage hidden(square(2, 6, 7));  // all but the lower edge
  EXPECT_FLOAT_EQ(hidden.triangle(0).edgeShare({40, 16}), 0);
}

TEST(EdgedTriangle, MovedCornersKeepTheirDepths) {
  const Stage stage(square(4, 7, 7, 1));
  const EdgedTriangle t = stage.triangle(0);
  const double moved = std::sqrt(0.5);
  EXPECT_NEAR(t.ndcDepth({48 + moved, 16 - moved}), 0.5, 1e-6);
  EXPECT_LT(t.ndcDepth({48, 20}), 0.5);
}

TEST(EdgedTriangle, WeightsAreThoseOfTheMovedCorners) {
  const Stage stage(square(4, 7, 7));
  const double moved = std::sqrt(0.5);
  const glm::vec2 w = stage.triangle(0).weights({48 + moved, 16 - moved});
  EXPECT_NEAR(w.x, 1, 1e-6);
  EXPECT_NEAR(w.y, 0, 1e-6);
}

TEST(EdgedTriangle, OutlinesAreFullyVisible) {
  // Lines of 8 pixels extend almost two pixels beyond the square's sides.
  const auto traced = test::trace(square(8, 7, 7));
  const auto plain = [] {
    auto s = square(8, 7, 7);
    s.shadings[0].fragment.edges = false;
    return test::trace(s);
  }();
  EXPECT_FALSE(plain.hit(32, 15));
  EXPECT_TRUE(traced.hit(32, 15));
  EXPECT_EQ(traced.color(32, 15), glm::vec4(255, 0, 0, 255));
  EXPECT_FALSE(traced.hit(32, 12));
  EXPECT_EQ(traced.color(40, 24), glm::vec4(255, 255, 255, 255));
  EXPECT_EQ(traced.color(32, 32), glm::vec4(255, 0, 0, 255));  // the diagonal
}

TEST(EdgedTriangle, TrianglesInFrontHideThem) {
  auto s = square(8, 7, 7);
  scene::Instance front = s.instances[0];
  front.mesh = test::makeMesh(test::squareData(0.5f));
  front.triangleEdges = {};
  front.order = 1;
  front.shading = 1;
  s.shadings.push_back(s.shadings[0]);
  s.shadings[1].fragment.edges = false;
  s.instances.push_back(front);
  const auto traced = test::trace(s);
  for (int x = 8; x < 56; ++x) EXPECT_EQ(traced.color(x, 15), glm::vec4(255, 255, 255, 255));
}

int differing(const test::Traced& a, const test::Traced& b) {
  int count = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      count += a.hit(x, y) != b.hit(x, y) ||
               (a.hit(x, y) && (a.color(x, y) != b.color(x, y) || a.depth(x, y) != b.depth(x, y)));
  return count;
}

TEST(EdgedTriangle, CulledTrianglesHideNothingAndDoNotGrow) {
  for (const float nearer : {0.2f, -0.2f}) {
    auto s = square(8, 7, 7, 0.1f);
    s.instances[0].cull = scene::CullFace::back;
    const auto alone = test::trace(s);
    // A larger back-facing square with edges, in front of or behind the first.
    scene::Instance other = s.instances[0];
    const float z = -nearer;
    other.mesh = test::makeMesh(
        test::quadData({0.6f, -0.6f, z}, {-0.6f, -0.6f, z}, {-0.6f, 0.6f, z}, {0.6f, 0.6f, z}));
    other.order = 1;
    s.instances.push_back(other);
    EXPECT_EQ(differing(test::trace(s), alone), 0);
    s.instances[1].cull = scene::CullFace::none;
    EXPECT_GT(differing(test::trace(s), alone), 100) << "it is there";
  }
}

TEST(EdgedTriangle, PlanesClipByTheDistancesOfTheirCorners) {
  auto s = square(8, 7, 7);
  s.instances[0].clipPlanes = {{0, 1, 0, 0.25}};  // window y from 24 on
  const auto traced = test::trace(s);
  for (int x = 24; x < 40; ++x) {
    EXPECT_FALSE(traced.hit(x, 22)) << x;
    EXPECT_TRUE(traced.hit(x, 25)) << x;
    EXPECT_TRUE(traced.hit(x, 48)) << "the upper side grows still";
  }
}

TEST(EdgedTriangle, DepthIsOffsetWithThem) {
  auto s = square(8, 7, 7, 0.5f);
  const auto before = test::trace(s);
  s.polygonOffset.units = 40, s.polygonOffset.resolution = 1 / 65000.0f;
  const auto after = test::trace(s);
  for (int x = 18; x < 46; x += 3)
    for (const int y : {15, 20, 32})
      EXPECT_NEAR(after.depth(x, y) - before.depth(x, y), 40 / 65000.0, 1e-6) << x << " " << y;
}

}  // namespace
}  // namespace gluray
