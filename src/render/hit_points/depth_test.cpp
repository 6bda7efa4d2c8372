// Window depth against planes intersected analytically.
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::trace;
using test::Traced;

// Half a float's step near 1, and the resolution of a 24-bit depth buffer.
constexpr double kDepthTolerance = 1.2e-7;

// Window depth, before polygon offset, at window position (x, y) of the plane dot(plane, eye) = 0.
double windowDepth(const scene::Camera& camera, const glm::dvec4& plane, double x, double y) {
  const glm::dmat4 eyeFromClip = glm::inverse(camera.clipFromEye);
  const double nx = 2 * (x - camera.viewport.x) / camera.viewport.z - 1;
  const double ny = 2 * (y - camera.viewport.y) / camera.viewport.w - 1;
  const glm::dvec4 near = eyeFromClip * glm::dvec4(nx, ny, -1, 1),
                   far = eyeFromClip * glm::dvec4(nx, ny, 1, 1);
  const double a = glm::dot(plane, near), b = glm::dot(plane, far);
  const double ndc = -1 + 2 * a / (a - b);  // homogeneous points are linear in NDC depth
  return 0.5 * (camera.depthFar - camera.depthNear) * ndc + 0.5 * (camera.depthFar + camera.depthNear);
}

// A large quad z = slope.x*x + slope.y*y + offset in eye space, placed by `eyeFromObject`.
scene::Snapshot planeScene(const glm::dmat4& clipFromEye, glm::dvec2 slope, double offset, double extent,
                           const glm::dmat4& eyeFromObject = glm::dmat4(1)) {
  const glm::dmat4 objectFromEye = glm::inverse(eyeFromObject);
  const auto corner = [&](double x, double y) {
    return glm::vec3(objectFromEye * glm::dvec4(x, y, slope.x * x + slope.y * y + offset, 1));
  };
  auto s = makeSnapshot({makeMesh(test::quadData(corner(-extent, -extent), corner(extent, -extent),
                                                 corner(extent, extent), corner(-extent, extent)))},
                        32);
  s.camera.clipFromEye = clipFromEye;
  s.eyeFromWorld = s.instances[0].eyeFromObject = eyeFromObject;
  return s;
}

void expectPlane(const scene::Snapshot& s, glm::dvec2 slope, double offset,
                 double tolerance = kDepthTolerance) {
  const Traced traced = trace(s);
  const glm::dvec4 plane(slope, -1, offset);
  int hits = 0;
  for (int y = 0; y < s.region.height; ++y) {
    for (int x = 0; x < s.region.width; ++x) {
      const double expected = windowDepth(s.camera, plane, s.region.x + x + 0.5, s.region.y + y + 0.5);
      const double lower = std::min(s.camera.depthNear, s.camera.depthFar);
      const double upper = std::max(s.camera.depthNear, s.camera.depthFar);
      if (std::min(std::abs(expected - lower), std::abs(expected - upper)) < 1e-4)
        continue;  // on a clipping plane
      const bool inside = expected > lower && expected < upper;
      ASSERT_EQ(traced.hit(x, y), inside) << x << ' ' << y << ' ' << expected;
      if (!inside) continue;
      ++hits;
      ASSERT_NEAR(traced.depth(x, y), expected, tolerance) << x << ' ' << y;
    }
  }
  EXPECT_GT(hits, s.region.width * s.region.height / 4);
}

const glm::dmat4 kPerspective = glm::perspective(0.9, 1.0, 1.0, 100.0);

TEST(Depth, Perspective) {
  expectPlane(planeScene(kPerspective, {0, 0}, -10, 50), {0, 0}, -10);
  expectPlane(planeScene(kPerspective, {0.7, -0.4}, -20, 200), {0.7, -0.4}, -20);
}

TEST(Depth, Orthographic) {
  const glm::dmat4 ortho = glm::ortho(-3.0, 5.0, -2.0, 6.0, -10.0, 30.0);
  expectPlane(planeScene(ortho, {0.5, 1.5}, -8, 20), {0.5, 1.5}, -8);
}

TEST(Depth, OffAxis) {
  const glm::dmat4 frustum = glm::frustum(-0.2, 1.0, -0.7, 0.1, 0.5, 50.0);
  expectPlane(planeScene(frustum, {-0.3, 0.2}, -12, 200), {-0.3, 0.2}, -12);
}

TEST(Depth, InfiniteFarPlane) {
  expectPlane(planeScene(glm::infinitePerspective(0.9, 1.0, 0.5), {0.1, 0.2}, -40, 200), {0.1, 0.2}, -40);
}

TEST(Depth, InfiniteFarPlaneInReversedRange) {
  auto s = planeScene(glm::infinitePerspective(0.9, 1.0, 0.5), {0.1, 0.2}, -40, 200);
  const auto nearer = planeScene(glm::infinitePerspective(0.9, 1.0, 0.5), {0.1, 0.2}, -10, 200);
  s.instances.push_back(nearer.instances[0]);
  s.camera.depthNear = 1, s.camera.depthFar = 0;
  expectPlane(s, {0.1, 0.2}, -40);
  // A projection that ends beyond infinity, as programs use to avoid rounding errors there.
  s.camera.clipFromEye = glm::tweakedInfinitePerspective(0.9, 1.0, 0.5, 1e-6);
  expectPlane(s, {0.1, 0.2}, -40);
}

TEST(Depth, Range) {
  auto s = planeScene(kPerspective, {0.3, 0.1}, -15, 100);
  s.camera.depthNear = 0.25f, s.camera.depthFar = 0.75f;
  expectPlane(s, {0.3, 0.1}, -15);
}

TEST(Depth, ReversedRangeShowsTheFarSide) {
  auto s = planeScene(kPerspective, {0, 0}, -10, 50);
  const auto further = planeScene(kPerspective, {0, 0}, -20, 50);
  s.instances.push_back(further.instances[0]);
  s.camera.depthNear = 1, s.camera.depthFar = 0;
  expectPlane(s, {0, 0}, -20);
}

TEST(Depth, LargestDepthIsNearestWhereOneOfRangeAndProjectionIsReversed) {
  const glm::dmat4 mirror = glm::scale(glm::dmat4(1), {1, 1, -1});
  for (const bool range : {false, true})
    for (const bool projection : {false, true}) {
      auto s = planeScene(projection ? mirror * kPerspective : kPerspective, {0, 0}, -10, 50);
      const auto further = planeScene(kPerspective, {0, 0}, -20, 50);
      s.instances.push_back(further.instances[0]);
      if (range) s.camera.depthNear = 1, s.camera.depthFar = 0;
      s.camera.largestWins = true;
      expectPlane(s, {0, 0}, range != projection ? -10 : -20);
    }
}

TEST(Depth, InfiniteFarPlaneInReversedProjection) {
  const glm::dmat4 mirror = glm::scale(glm::dmat4(1), {1, 1, -1});
  auto s = planeScene(mirror * glm::infinitePerspective(0.9, 1.0, 0.5), {0.1, 0.2}, -10, 200);
  s.camera.largestWins = true;
  expectPlane(s, {0.1, 0.2}, -10);
}

TEST(Depth, ViewportAndRegionElsewhere) {
  auto s = planeScene(kPerspective, {0.3, 0.1}, -15, 100);
  s.camera.viewport = {-7, 11, 60, 45};
  s.region = {3, 20, 21, 13};
  expectPlane(s, {0.3, 0.1}, -15);
}

TEST(Depth, ModelviewFarFromTheOrigin) {
  // As in ParaView: the eye a million units away, near and far planes close around the data.
  glm::dmat4 modelview = glm::translate(glm::dmat4(1), {0, 0, -1e6});
  modelview = glm::rotate(modelview, 0.6, glm::dvec3(1, 2, 0.5));
  const glm::dmat4 projection = glm::perspective(2e-4, 1.0, 1e6 - 300, 1e6 + 300);
  // Float vertices of magnitude 200 round by 8e-6, that is 1.3e-8 of the depth range of 600.
  expectPlane(planeScene(projection, {0.4, -0.2}, -1e6, 200, modelview), {0.4, -0.2}, -1e6, 2e-7);
}

TEST(Depth, TinyAndHugeScales) {
  for (const double scale : {1e-6, 1e6}) {
    const glm::dmat4 modelview = glm::scale(glm::dmat4(1), glm::dvec3(scale));
    expectPlane(planeScene(kPerspective, {0.3, 0.1}, -15, 100, modelview), {0.3, 0.1}, -15, 5e-7);
  }
}

TEST(Depth, PolygonOffset) {
  const glm::dvec2 slope(0.3, -0.8);
  auto s = planeScene(kPerspective, slope, -15, 100);
  s.polygonOffset = {1.5f, 40, 1.0f / 65536};
  const Traced traced = trace(s);
  const glm::dvec4 plane(slope, -1, -15.0);
  for (const auto& [x, y] : {std::pair(3, 5), std::pair(16, 16), std::pair(30, 9)}) {
    const double here = windowDepth(s.camera, plane, x + 0.5, y + 0.5);
    const double dx = windowDepth(s.camera, plane, x + 1.5, y + 0.5) - here;
    const double dy = windowDepth(s.camera, plane, x + 0.5, y + 1.5) - here;
    const double expected = here + 1.5 * std::max(std::abs(dx), std::abs(dy)) + 40.0 / 65536;
    EXPECT_NEAR(traced.depth(x, y), std::min(expected, 1.0), kDepthTolerance);
  }
}

TEST(Depth, PolygonOffsetIsClamped) {
  auto s = planeScene(kPerspective, {0, 0}, -15, 100);
  s.polygonOffset = {0, 1e9f, 1};
  EXPECT_EQ(trace(s).depth(16, 16), 1.0f);
  s.polygonOffset = {0, -1e9f, 1};
  EXPECT_EQ(trace(s).depth(16, 16), 0.0f);
}

TEST(Depth, PolygonOffsetOfFloats) {
  // One unit in the last place of the triangle's largest depth, whatever the pixel's depth.
  const struct {
    float left, right;  // z of the square's sides; the window depth is 0.5 - z/2
    double digit;
  } cases[] = {{0.9f, 0.9f, 0x1p-28}, {0.2f, 0.2f, 0x1p-25}, {-0.7f, -0.7f, 0x1p-24}, {0.9f, 0.2f, 0x1p-25}};
  for (const auto& [left, right, digit] : cases) {
    auto s = makeSnapshot(
        {makeMesh(test::quadData({-1, -1, left}, {1, -1, right}, {1, 1, right}, {-1, 1, left}))});
    const float plain = trace(s).depth(2, 8);
    s.polygonOffset.units = 65536, s.polygonOffset.floats = true;
    EXPECT_NEAR(trace(s).depth(2, 8) - plain, 65536 * digit, kDepthTolerance) << left << ' ' << right;
  }
}

TEST(Depth, InstancesAgreeWithTheirModelview) {
  auto s = planeScene(kPerspective, {0.3, 0.1}, -15, 100);
  const glm::dmat4 modelview =
      glm::translate(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 1, 0.2)), {1, 2, -3});
  auto other = planeScene(kPerspective, {-0.2, 0.5}, -12, 100, modelview).instances[0];
  other.worldFromObject = glm::mat4(modelview);
  s.instances = {s.instances[0], other};
  s.instances[0].mesh = makeMesh({});
  expectPlane(s, {-0.2, 0.5}, -12, 1e-6);
}

TEST(Depth, SamplesHaveTheirOwnPlanes) {
  auto s = planeScene(kPerspective, {0.7, -0.4}, -20, 200);
  s.samples = 2;
  s.samplePositions = {{0.25f, 0.125f}, {0.75f, 0.875f}};
  const Traced traced = trace(s);
  ASSERT_EQ(traced.image.samples, 2);
  ASSERT_EQ(traced.image.depth.size(), 2u * 32 * 32);
  for (int sample = 0; sample < 2; ++sample) {
    const glm::vec2 at = s.samplePositions[static_cast<size_t>(sample)];
    EXPECT_NEAR(traced.depth(20, 12, sample),
                windowDepth(s.camera, {0.7, -0.4, -1, -20}, 20 + at.x, 12 + at.y), kDepthTolerance);
  }
}

}  // namespace
}  // namespace gluray
