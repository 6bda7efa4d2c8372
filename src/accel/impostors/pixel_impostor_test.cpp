// Beads and tubes against a rasteriser and VTK's formulas; their bounding boxes.
#include "accel/impostors/pixel_impostor.h"

#include "accel/testing/test_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray::accel {
namespace {

using scene::Shape;

constexpr int kWidth = 200, kHeight = 100;

struct PixelScene {
  scene::Camera camera;
  scene::Instance instance;
  PlacedImpostors placed;
  explicit PixelScene(Shape shape, std::vector<glm::vec3> points, float pixels, bool parallel = false) {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->shape = shape;
    mesh->vertexCount = static_cast<uint32_t>(points.size());
    mesh->triangleCount = mesh->vertexCount / scene::cornersOf(shape);
    mesh->lower = mesh->upper = points.front();
    for (const glm::vec3& p : points)
      mesh->lower = glm::min(mesh->lower, p), mesh->upper = glm::max(mesh->upper, p);
    mesh->positions = test::makeAttribute(std::move(points), scene::Format::float3);
    instance.mesh = mesh;
    camera.viewport = {0, 0, kWidth, kHeight};
    camera.clipFromEye = parallel ? glm::ortho(-2.0, 2.0, -1.0, 1.0, 1.0, 20.0)
                                  : glm::perspective(glm::radians(60.0), 2.0, 1.0, 20.0);
    scene::Impostors& f = instance.impostors;
    f.parallelView = parallel;
    f.size = 2 * pixels / glm::vec2(kWidth, kHeight);
    // VTK's values.
    const double zz = camera.clipFromEye[2][2];
    f.bulge = static_cast<float>(pixels / (kWidth * camera.clipFromEye[0][0]));
    f.bulgeDepth = static_cast<float>(parallel ? zz : 0.5 - 0.5 * zz);
    place();
  }
  void place() {
    placed = PlacedImpostors(instance, camera);
    placed.window = windowVertices(placed);
  }
  PixelImpostor impostor(uint32_t primitive = 0) const {
    PixelImpostor f(placed, primitive);
    f.prepare();
    return f;
  }
  double windowDepth(const glm::vec3& eye) const {
    const glm::dvec4 clip = camera.clipFromEye * glm::dvec4(eye, 1);
    return 0.5 + 0.5 * clip.z / clip.w;
  }
};

int covered(const PixelImpostor& impostor) {
  int count = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) count += impostor.covers({x + 0.5, y + 0.5});
  return count;
}

TEST(PixelImpostor, AxisAlignedTubesCoverWidthTimesLength) {
  // 50 pixels long, from the window's middle to the right; its sides, at 47.5 and 52.5, lie on pixel centres.
  const PixelScene flat(Shape::tubes, {{0, 0, -5}, {1, 0, -5}}, 5, true);
  EXPECT_EQ(covered(flat.impostor()), 5 * 50);
  EXPECT_TRUE(flat.impostor().covers({120.5, 47.5})) << "the lower side is owned";
  EXPECT_FALSE(flat.impostor().covers({120.5, 52.5})) << "the upper one is not";
  const PixelScene tall(Shape::tubes, {{0, 0, -5}, {0, 0.8f, -5}}, 4, true);
  EXPECT_EQ(covered(tall.impostor()), 4 * 40);
}

TEST(PixelImpostor, NearbyIncludesAllCoveredPositions) {
  for (const int way : {0, 1, 2}) {
    PixelScene s(Shape::tubes, {{-1.5f, -0.7f, -6}, {1.2f, 0.9f, -3}}, 9.5f);
    s.instance.impostors.grows = way == 1, s.instance.impostors.inPixels = way == 2;
    s.instance.impostors.longer = 2;
    s.place();
    const PixelImpostor impostor = s.impostor();
    int near = 0, hits = 0;
    for (int y = 0; y < kHeight; y += 4) {
      for (int x = 0; x < kWidth; x += 4) {
        PixelRays rays{};
        for (int i = 0; i < kLanes; ++i)
          rays.windowX[i] = static_cast<float>(x + i % 4) + 0.5f,
          rays.windowY[i] = static_cast<float>(y + i / 4) + 0.5f;
        const uint32_t lanes = impostor.nearby(rays, 0xFFFF);
        for (int i = 0; i < kLanes; ++i) {
          const bool covers = impostor.covers({rays.windowX[i], rays.windowY[i]});
          EXPECT_TRUE(!covers || (lanes >> i & 1)) << x << " " << y;
          near += static_cast<int>(lanes >> i & 1), hits += covers;
        }
      }
    }
    EXPECT_GT(hits, 300);
    EXPECT_LT(near, hits + hits / 10);
  }
}

TEST(PixelImpostor, ShortTubesGrowByAQuarterOfTheDifference) {
  PixelScene s(Shape::tubes, {{0, 0, -5}, {0.08f, 0, -5}}, 20, true);  // 4 pixels long, 20 wide
  EXPECT_EQ(covered(s.impostor()), 4 * 20);
  s.instance.impostors.grows = true;
  s.place();
  // In normalised device coordinates: length of the size less that of the line, a quarter of it at each end.
  const double missing = std::hypot(0.2, 0.4) - 0.04;
  EXPECT_NEAR(covered(s.impostor()), 20 * (4 + 2 * 0.25 * missing * kWidth / 2), 20);
}

TEST(PixelImpostor, TubesInPixelsHaveTheirWidthInTheWindow) {
  PixelScene s(Shape::tubes, {{0, 0, -5}, {0.6f, 0.6f, -5}}, 8, true);  // 30 pixels along both axes
  const auto covers = [&](double along, double aside) {
    const glm::dvec2 end(130, 80), way = glm::dvec2(1, 1) / std::sqrt(2.0), normal(-way.y, way.x);
    return s.impostor().covers(end + along * way + aside * normal);
  };
  s.instance.impostors.inPixels = true;
  s.place();
  EXPECT_TRUE(covers(-20, 3.9) && covers(-20, -3.9) && covers(-0.1, 0));
  EXPECT_FALSE(covers(-20, 4.1) || covers(-20, -4.1) || covers(0.1, 0));
  s.instance.impostors.longer = 3;
  s.place();
  EXPECT_TRUE(covers(2.9, 3.9) && covers(2.9, -3.9));
  EXPECT_FALSE(covers(3.1, 0));
}

TEST(PixelImpostor, TubesInPixelsThatArePointsRunToTheRight) {
  PixelScene s(Shape::tubes, {{0, 0, -5}, {0, 0, -6}}, 8, true);
  EXPECT_EQ(covered(s.impostor()), 0);
  s.instance.impostors.inPixels = true, s.instance.impostors.longer = 2;
  s.place();
  EXPECT_EQ(covered(s.impostor()), 2 * 8);
  PixelImpostor::Shown shown;
  ASSERT_TRUE(s.impostor().show({100.5, 52.5}, shown));
  EXPECT_NEAR(shown.normal.z, 0, 1e-6f) << "the tube points at the viewer";
}

TEST(PixelImpostor, TheMiddleOfATubeIsARadiusNearer) {
  const PixelScene s(Shape::tubes, {{-1, 0, -5}, {1, 0, -5}}, 10);
  PixelImpostor::Shown shown;
  ASSERT_TRUE(s.impostor().show({100, 50}, shown));
  const float radius =
      10.0f / kWidth * 5 / static_cast<float>(s.camera.clipFromEye[0][0]);  // 5 away, half of 10 pixels
  EXPECT_NEAR(shown.depth, s.windowDepth({0, 0, -5 + radius}), 1e-6);
  EXPECT_NEAR(shown.along, 0.5, 1e-6);
  EXPECT_LT(glm::length(shown.normal - glm::vec3(0, 0, 1)), 1e-4f);
  ASSERT_TRUE(s.impostor().show({100, 53}, shown));
  EXPECT_NEAR(shown.normal.y, 0.6f, 1e-4f);
  EXPECT_NEAR(shown.normal.z, 0.8f, 1e-4f);
}

TEST(PixelImpostor, BeadsAreRoundAndClippedByTheirCentres) {
  const PixelScene s(Shape::beads, {{0, 0, -5}, {0, 0, -0.5f}, {9, 0, -5}}, 12);
  EXPECT_EQ(covered(s.impostor()), 12 * 12) << "the billboard is square";
  EXPECT_EQ(covered(s.impostor(1)), 0) << "before the near plane";
  EXPECT_EQ(covered(s.impostor(2)), 0) << "beside the window";
  PixelImpostor::Shown shown;
  EXPECT_FALSE(s.impostor().show({105, 55}, shown));
  ASSERT_TRUE(s.impostor().show({103.6, 50}, shown));
  EXPECT_NEAR(shown.normal.x, 0.6f, 1e-4f);
  EXPECT_NEAR(shown.normal.z, 0.8f, 1e-4f);
}

/// Whether a triangle in clip space, cut at the near plane, covers a position in normalised device
/// coordinates.
bool coversNdc(std::vector<glm::dvec4> corners, const glm::dvec2& at) {
  std::vector<glm::dvec2> cut;
  for (size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec4 a = corners[i], b = corners[(i + 1) % corners.size()];
    const double da = a.z + a.w, db = b.z + b.w;
    if (da >= 0) cut.push_back(glm::dvec2(a) / a.w);
    if ((da >= 0) == (db >= 0)) continue;
    const glm::dvec4 p = a + da / (da - db) * (b - a);
    cut.push_back(glm::dvec2(p) / p.w);
  }
  bool inside = false;
  for (size_t i = 0, k = cut.size() - 1; i < cut.size(); k = i++) {
    if ((cut[i].y > at.y) == (cut[k].y > at.y)) continue;
    const double x = cut[k].x + (at.y - cut[k].y) / (cut[i].y - cut[k].y) * (cut[i].x - cut[k].x);
    if (at.x < x) inside = !inside;
  }
  return inside;
}

TEST(PixelImpostor, LinesThatEndBehindTheViewerAreTwoTrianglesCutAtTheNearPlane) {
  const glm::vec3 ends[] = {{-0.5f, -0.3f, -8}, {0.5f, 0.4f, 3}};
  const PixelScene s(Shape::tubes, {ends[0], ends[1]}, 6);
  glm::dvec4 clip[2], corners[4];
  for (int k = 0; k < 2; ++k) clip[k] = s.camera.clipFromEye * glm::dvec4(ends[k], 1);
  const glm::dvec2 d = glm::normalize(glm::dvec2(clip[1]) / clip[1].w - glm::dvec2(clip[0]) / clip[0].w);
  for (int j = 0; j < 4; ++j) {
    corners[j] = clip[j / 2];
    const glm::dvec2 aside =
        glm::dvec2(s.instance.impostors.size) * glm::dvec2(-d.y, d.x) * (j % 2 ? -0.5 : 0.5);
    corners[j] += glm::dvec4(aside * clip[j / 2].w, 0, 0);
  }
  const PixelImpostor impostor = s.impostor();
  int hits = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec2 at(x + 0.5, y + 0.5), ndc = (at - s.placed.windowCenter) / s.placed.windowHalf;
      const bool expected = coversNdc({corners[0], corners[1], corners[2]}, ndc) ||
                            coversNdc({corners[1], corners[2], corners[3]}, ndc);
      EXPECT_EQ(impostor.covers(at), expected) << x << " " << y;
      hits += expected;
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(PixelImpostor, PlanesCutTheLine) {
  PixelScene s(Shape::tubes, {{-1, 0, -5}, {1, 0, -5}}, 10);
  s.instance.impostors.centerPlanes = {{1, 0, 0, -0.25f}};
  s.place();
  PixelImpostor::Shown shown;
  EXPECT_FALSE(s.impostor().show({100, 50}, shown));
  EXPECT_TRUE(s.impostor().show({110, 50}, shown));
}

TEST(PixelImpostor, BoundsContainEveryHit) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 60; ++i) {
    const auto t = static_cast<float>(i);
    points.push_back({std::sin(1.7f * t), std::sin(2.3f * t + 1), std::cos(0.9f * t)});
  }
  int hits = 0;
  const std::pair<Shape, bool> kinds[] = {{Shape::beads, false}, {Shape::tubes, false}, {Shape::tubes, true}};
  for (const auto& [shape, inPixels] : kinds) {
    for (const bool parallel : {false, true}) {
      for (const double away : {1.2, 2.5, 12.0}) {
        PixelScene s(shape, points, 14, parallel);
        s.instance.impostors.inPixels = inPixels, s.instance.impostors.longer = 1;
        s.instance.impostors.grows = !inPixels, s.instance.impostors.depthBias = -8 / 65000.0f;
        const glm::mat4 turned = glm::rotate(glm::mat4(1), 0.7f, glm::vec3(1, 2, 3));
        s.instance.eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, -away}) * glm::dmat4(turned);
        s.instance.eyeFromObject = s.instance.eyeFromObject * glm::scale(glm::dmat4(1), {1, 0.3, 0.5});
        s.instance.lightingFromObject = glm::mat4(s.instance.eyeFromObject);
        s.place();
        const ImpostorReach reach = reachOf(s.instance, s.camera);
        const glm::dmat4 objectFromClip = glm::inverse(s.placed.clipFromObject);
        for (uint32_t k = 0; k < s.instance.mesh->triangleCount; ++k) {
          Box box = boundsOfImpostor(*s.instance.mesh, reach, k);
          const PixelImpostor impostor = s.impostor(k);
          for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
              const glm::dvec2 at(x + 0.5, y + 0.5);
              PixelImpostor::Shown shown;
              if (!impostor.covers(at) || !impostor.show(at, shown) || shown.depth <= 0) continue;
              ++hits;
              const glm::dvec4 p =
                  objectFromClip *
                  glm::dvec4((at - s.placed.windowCenter) / s.placed.windowHalf, 2 * shown.depth - 1, 1);
              const glm::vec3 object(glm::dvec3(p) / p.w);
              ASSERT_TRUE(glm::all(glm::lessThanEqual(box.lower, object)) &&
                          glm::all(glm::lessThanEqual(object, box.upper)))
                  << static_cast<int>(shape) << parallel << away << " impostor " << k;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(hits, 20000);
}

TEST(PixelImpostor, ReachIsRotationInvariantAndGrowsWithDistance) {
  PixelScene s(Shape::tubes, {{-1, -1, -1}, {1, 1, 1}}, 6);
  const auto reachAt = [&](double degrees, double away) {
    s.instance.eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, -away}) *
                               glm::rotate(glm::dmat4(1), glm::radians(degrees), glm::dvec3(1, 2, 3));
    s.instance.lightingFromObject = glm::mat4(s.instance.eyeFromObject);
    return reachOf(s.instance, s.camera);
  };
  const ImpostorReach first = reachAt(0, 6);
  for (int i = 1; i < 30; ++i) EXPECT_EQ(reachAt(11 * i, 6), first);
  EXPECT_GT(reachAt(0, 12).perRadius.x, 1.3f * first.perRadius.x);
}

}  // namespace
}  // namespace gluray::accel
