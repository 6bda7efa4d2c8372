// Surfaces in one step of a coarse depth buffer: the order of drawing decides which is visible.
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gluray {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::trace;
using test::Traced;

constexpr double kSteps = 65535;
constexpr int kSize = 32;

/// The plane z = -10 + slope.x * x + slope.y * y in eye space.
struct Sheet {
  glm::dvec2 slope;
  /// Window depth at a window position.
  double depthAt(const scene::Camera& camera, const glm::dvec2& window) const {
    const glm::dmat4 eyeFromClip = glm::inverse(camera.clipFromEye);
    const glm::dvec2 ndc = 2.0 * window / double{kSize} - 1.0;
    const glm::dvec4 plane(slope, -1, -10);
    const double a = glm::dot(plane, eyeFromClip * glm::dvec4(ndc, -1, 1)),
                 b = glm::dot(plane, eyeFromClip * glm::dvec4(ndc, 1, 1));
    const double z = -1 + 2 * a / (a - b);  // homogeneous points are linear in NDC depth
    return 0.5 * (camera.depthFar - camera.depthNear) * z + 0.5 * (camera.depthFar + camera.depthNear);
  }
  test::MeshData mesh() const {
    const auto corner = [&](double x, double y) {
      return glm::vec3(glm::dvec3(x, y, slope.x * x + slope.y * y - 10));
    };
    return test::quadData(corner(-50, -50), corner(50, -50), corner(50, 50), corner(-50, 50));
  }
};

/// Two sheets at such an angle that depths of 16 bits are equal in wide strips on both sides of their line.
const Sheet kSheets[] = {{{0.08, 0.03}}, {{0.0807, 0.03}}};

scene::Snapshot wedge(const glm::dmat4& projection) {
  auto s = makeSnapshot({makeMesh(kSheets[0].mesh()), makeMesh(kSheets[1].mesh())}, kSize);
  s.camera.clipFromEye = projection;
  s.depthSteps = kSteps;
  s.instances[0].color = {1, 0, 0, 1}, s.instances[1].color = {0, 0, 1, 1};
  s.instances[1].order = 1;
  return s;
}

struct Counts {
  int pixels = 0, equal = 0, byOrder = 0;  // byOrder: where the nearer one is hidden
};

/// Expects the sheet that OpenGL's depth test leaves in each sample.
Counts expectVisible(const scene::Snapshot& s) {
  const Traced traced = trace(s);
  Counts counts;
  for (int sample = 0; sample < s.samples; ++sample)
    for (int i = 0; i < kSize * kSize; ++i) {
      const glm::dvec2 within = s.samples > 1 ? glm::dvec2(s.samplePositions[sample]) : glm::dvec2(0.5);
      const glm::dvec2 at = glm::dvec2(i % kSize, i / kSize) + within;
      const double depth[] = {kSheets[0].depthAt(s.camera, at), kSheets[1].depthAt(s.camera, at)};
      const double steps[] = {depth[0] * kSteps, depth[1] * kSteps};
      constexpr double kRounding = 0.01;  // steps: floats round to either side
      if (std::ranges::any_of(steps, [](double n) { return std::abs(n - std::floor(n) - 0.5) < kRounding; }))
        continue;
      const double apart = (std::round(steps[0]) - std::round(steps[1])) * (s.camera.largestWins ? -1 : 1);
      const bool laterSheet = s.instances[1].order > s.instances[0].order;
      const bool second = apart != 0 ? apart > 0 : laterSheet == s.laterWins;
      const glm::vec4 color = traced.color(i % kSize, i / kSize, sample);
      EXPECT_EQ(color.b > 128, second) << at.x << ' ' << at.y << ' ' << steps[0] << ' ' << steps[1];
      ++counts.pixels;
      counts.equal += apart == 0;
      counts.byOrder += second != ((depth[0] > depth[1]) != s.camera.largestWins);
    }
  return counts;
}

/// In both orders of drawing, for both depth functions.
void expectOrderDecides(scene::Snapshot s) {
  for (const bool laterWins : {false, true})
    for (const uint32_t first : {0u, 1u}) {
      s.laterWins = laterWins;
      s.instances[0].order = first, s.instances[1].order = 1 - first;
      const Counts counts = expectVisible(s);
      EXPECT_GT(counts.pixels, s.samples * kSize * kSize * 9 / 10);
      EXPECT_GT(counts.equal, s.samples * 60);
      EXPECT_GT(counts.byOrder, s.samples * 20);
    }
}

const glm::dmat4 kPerspective = glm::perspective(0.9, 1.0, 1.0, 100.0);

TEST(CoarseDepth, OrderDecidesWithinAStep) { expectOrderDecides(wedge(kPerspective)); }

TEST(CoarseDepth, InParallelProjections) {
  expectOrderDecides(wedge(glm::ortho(-5.0, 5.0, -5.0, 5.0, 1.0, 100.0)));
}

TEST(CoarseDepth, WithinARangeOfDepths) {
  auto s = wedge(kPerspective);
  s.camera.depthNear = 0.3f, s.camera.depthFar = 0.9f;
  expectOrderDecides(s);
}

TEST(CoarseDepth, WhereTheLargestDepthIsVisible) {
  auto s = wedge(kPerspective);
  s.camera.largestWins = true;
  expectOrderDecides(s);
  s.camera.depthNear = 1, s.camera.depthFar = 0;
  expectOrderDecides(s);
}

TEST(CoarseDepth, InEachSample) {
  auto s = wedge(kPerspective);
  s.samples = 4;
  s.samplePositions = {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};
  expectOrderDecides(s);
  s.settings.shading = ShadingRate::sample;
  expectOrderDecides(s);
}

TEST(CoarseDepth, FineDepthsAreComparedExactly) {
  auto s = wedge(kPerspective);
  s.depthSteps = 0;
  const Traced traced = trace(s);
  int second = 0;
  for (int i = 0; i < kSize * kSize; ++i) {
    const glm::dvec2 at = glm::dvec2(i % kSize, i / kSize) + 0.5;
    const double apart = kSheets[0].depthAt(s.camera, at) - kSheets[1].depthAt(s.camera, at);
    if (std::abs(apart) < 1e-7) continue;
    EXPECT_EQ(traced.color(i % kSize, i / kSize).b > 128, apart > 0) << at.x << ' ' << at.y;
    second += apart > 0;
  }
  EXPECT_GT(second, 300);
}

TEST(CoarseDepth, HiddenFacesAreNotSeenForTheirOrder) {
  // The later sheet faces away and is culled, although the order of drawing would show it.
  auto s = wedge(kPerspective);
  s.laterWins = true;
  s.instances[1].cull = scene::CullFace::back, s.instances[1].frontFaceCcw = false;
  const Traced traced = trace(s);
  for (int i = 0; i < kSize * kSize; ++i) ASSERT_LT(traced.color(i % kSize, i / kSize).b, 1) << i;
}

}  // namespace
}  // namespace gluray
