// Depth of field: blur of known size, sharpness in focus, and nothing at all where it is off.
#include "render/camera/lens.h"

#include "base/sanitized.h"
#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

constexpr int kEdgeSize = 64;

/// A half plane x < edge at distance `depth` from a camera at the origin that looks along -z.
scene::MeshPtr halfPlane(double depth, double edge, double scale) {
  const auto at = [&](double x, double y) { return glm::vec3(glm::dvec3(x, y, -depth) * scale); };
  return test::makeMesh(test::quadData(at(-20, -20), at(edge, -20), at(edge, 20), at(-20, 20)));
}

scene::Snapshot focusedView(const std::vector<scene::MeshPtr>& meshes, double scale = 1) {
  scene::Snapshot s = test::makeSnapshot(meshes, kEdgeSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1 * scale, 1000.0 * scale);
  s.settings.camera.aperture = static_cast<float>(0.2 * scale);
  s.settings.camera.focus = static_cast<float>(5 * scale);
  s.settings.spp = 256;
  return s;
}

/// The share of a disc of radius 1 to the left of x.
double discLeftOf(double x) {
  x = std::clamp(x, -1.0, 1.0);
  return (x * std::sqrt(1 - x * x) + std::asin(x)) / M_PI + 0.5;
}

/// The largest difference, in any column, from an edge at window position `edge` that is blurred by a disc of
/// `radius` pixels and by the pixel.
double errorOfEdge(const test::Traced& traced, double edge, double radius) {
  double error = 0;
  for (int x = 0; x < kEdgeSize; ++x) {
    double expected = 0, mean = 0;
    constexpr int kSteps = 64;
    for (int k = 0; k < kSteps; ++k) {
      const double from = edge - (x + (k + 0.5) / kSteps);
      expected += radius > 0 ? discLeftOf(from / radius) : from > 0 ? 1 : 0;
    }
    for (int y = 0; y < kEdgeSize; ++y) mean += double{traced.color(x, y).a} / 255;
    error = std::max(error, std::abs(mean / kEdgeSize - expected / kSteps));
  }
  return error;
}

/// Pixels that a length at a distance takes in the view of focusedView().
double pixelsAt(double depth) { return kEdgeSize / (2 * depth * std::tan(glm::radians(20.0))); }

// The samples' positions are the same in all pixels: a share that 256 of them measure is off by a few.
constexpr double kNoise = 4.0 / 256;

TEST(Lens, BlursAnEdgeByTheThinLensFormula) {
  GLURAY_RELEASE_ONLY();
  for (const double depth : {2.5, 4.0, 8.0, 20.0}) {
    const test::Traced traced = test::trace(focusedView({halfPlane(depth, 0.1, 1)}));
    const double radius = 0.2 * std::abs(depth - 5) / 5 * pixelsAt(depth);
    EXPECT_GT(radius, 0.5);
    EXPECT_LT(errorOfEdge(traced, kEdgeSize / 2 + 0.1 * pixelsAt(depth), radius), kNoise) << depth;
  }
}

TEST(Lens, OfAnFNumberHasThisPartOfTheFocalLength) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
  s.settings.camera.aperture = 0;
  s.settings.camera.film = 0.5f;
  const double behind = 0.25 / std::tan(glm::radians(20.0)), focalLength = 5 * behind / (5 + behind);
  for (const double number : {1.4, 2.8}) {
    s.settings.camera.fNumber = static_cast<float>(number);
    const double radius = focalLength / number / 2 * 3 / 5 * pixelsAt(8);
    EXPECT_GT(radius, 0.5);
    EXPECT_LT(errorOfEdge(test::trace(s), kEdgeSize / 2 + 0.1 * pixelsAt(8), radius), kNoise) << number;
  }
}

TEST(Lens, OfAnFNumberIsTheSameWhereTheProjectionHoldsTheView) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot plain = focusedView({halfPlane(8, 0.1, 1)});
  plain.settings.camera.fNumber = 1.4f, plain.settings.camera.film = 0.5f;
  scene::Snapshot whole = plain;
  const glm::dmat4 view = glm::rotate(glm::dmat4(1), 0.3, {1.0, 2.0, 3.0});
  whole.camera.clipFromEye = plain.camera.clipFromEye * view;
  whole.eyeFromWorld = whole.instances[0].eyeFromObject = glm::inverse(view);
  const test::Traced a = test::trace(plain), b = test::trace(whole);
  for (int x = 0; x < kEdgeSize; ++x) ASSERT_NEAR(a.color(x, 32).a, b.color(x, 32).a, 6) << x;
}

TEST(Lens, OfAnFNumberIsClosedForParallelProjections) {
  scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
  s.camera.clipFromEye = glm::ortho(-2.0, 2.0, -2.0, 2.0, 1.0, 20.0);
  s.settings.camera.aperture = 0;
  const test::Traced sharp = test::trace(s);
  s.settings.camera.fNumber = 1.4f;
  EXPECT_EQ(test::trace(s).image.color, sharp.image.color);
}

TEST(Lens, KeepsWhatIsInFocusSharp) {
  const test::Traced traced = test::trace(focusedView({halfPlane(5, 0.1, 1)}));
  EXPECT_LT(errorOfEdge(traced, kEdgeSize / 2 + 0.1 * pixelsAt(5), 0), kNoise);
}

TEST(Lens, BlursAtAnyScale) {
  GLURAY_RELEASE_ONLY();
  for (const double scale : {1e-6, 1e6}) {
    const test::Traced traced = test::trace(focusedView({halfPlane(8, 0.1, scale)}, scale));
    const double radius = 0.2 * 3 / 5 * pixelsAt(8);
    EXPECT_LT(errorOfEdge(traced, kEdgeSize / 2 + 0.1 * pixelsAt(8), radius), kNoise) << scale;
  }
}

TEST(Lens, IsTheSameWhereTheWorldIsScaledUnevenly) {
  scene::Snapshot plain = focusedView({halfPlane(8, 0.1, 1)});
  const glm::dvec3 scale(100, 1, 0.01);
  std::shared_ptr<scene::Mesh> mesh = test::makeMesh(
      test::quadData(glm::vec3(-20, -20, -8) / glm::vec3(scale), glm::vec3(0.1, -20, -8) / glm::vec3(scale),
                     glm::vec3(0.1, 20, -8) / glm::vec3(scale), glm::vec3(-20, 20, -8) / glm::vec3(scale)));
  scene::Snapshot scaled = focusedView({mesh});
  scaled.eyeFromWorld = scaled.instances[0].eyeFromObject = glm::scale(glm::dmat4(1), scale);
  const test::Traced a = test::trace(plain), b = test::trace(scaled);
  for (int y = 0; y < kEdgeSize; ++y)
    for (int x = 0; x < kEdgeSize; ++x) ASSERT_LE(test::difference(a.color(x, y), b.color(x, y)), 3);
}

TEST(Lens, OfAParallelProjectionBlursByDistanceAlone) {
  GLURAY_RELEASE_ONLY();
  for (const double near : {0.1, -3.0}) {  // the lens is at the eye, or at a near plane behind it
    for (const double depth : {2.0, 5.0, 9.0}) {
      scene::Snapshot s = focusedView({halfPlane(depth, 0.1, 1)});
      s.camera.clipFromEye = glm::ortho(-2.0, 2.0, -2.0, 2.0, near, 50.0);
      const double pixels = kEdgeSize / 4.0, lens = std::min(near, 0.0);
      const double radius = 0.2 * std::abs(depth - 5) / (5 - lens) * pixels;
      EXPECT_LT(errorOfEdge(test::trace(s), kEdgeSize / 2 + 0.1 * pixels, radius), kNoise)
          << depth << " " << near;
    }
  }
}

TEST(Lens, OfAnAsymmetricFrustum) {
  scene::Snapshot s = focusedView({halfPlane(10, 0.1, 1)});
  s.camera.clipFromEye = glm::frustum(-0.02, 0.06, -0.05, 0.03, 0.1, 1000.0);
  const double pixels = kEdgeSize / (0.8 * 10);
  EXPECT_LT(errorOfEdge(test::trace(s), (0.2 * 10 + 0.1) * pixels, 0.2 * 5 / 5 * pixels), kNoise);
}

TEST(Lens, OfAProjectionThatHoldsTheViewIsTheSame) {
  GLURAY_RELEASE_ONLY();
  // Some programs put the camera's place into the projection matrix.
  const glm::dmat4 view = glm::lookAt(glm::dvec3(3, 4, 5), glm::dvec3(0, 1, 0), glm::dvec3(0, 1, 0));
  scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
  const glm::dmat4 projection = s.camera.clipFromEye;
  for (const double scale : {1.0, 0.01, 100.0}) {  // and scale their coordinates
    const glm::dmat4 viewFromEye = glm::scale(view, glm::dvec3(scale));
    s.camera.clipFromEye = projection * viewFromEye;
    s.eyeFromWorld = s.instances[0].eyeFromObject = glm::inverse(viewFromEye);
    const double radius = 0.2 * 3 / 5 * pixelsAt(8);
    EXPECT_LT(errorOfEdge(test::trace(s), kEdgeSize / 2 + 0.1 * pixelsAt(8), radius), kNoise) << scale;
  }
}

TEST(Lens, DepthIsThatOfTheViewpoint) {
  scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1), halfPlane(3, -0.4, 1)});
  const test::Traced blurred = test::trace(s);
  s.settings.camera.aperture = 0;
  s.settings.spp = 1;
  EXPECT_EQ(blurred.image.centerDepth, test::trace(s).image.depth);
}

TEST(Lens, ClosedIsNoLens) {
  scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
  s.settings.camera.aperture = 0;
  for (const int spp : {1, 16}) {
    s.settings.spp = spp;
    s.settings.camera.focus = 5;
    const test::Traced a = test::trace(s);
    s.settings.camera.focus = 0;
    const test::Traced b = test::trace(s);
    EXPECT_EQ(a.image.color, b.image.color);
    EXPECT_EQ(a.image.isAverages(), spp > 1);
  }
}

TEST(Lens, FocusesAtWhatTheViewShows) {
  GLURAY_RELEASE_ONLY();
  // A near half plane on the left, a far one behind it.
  scene::Snapshot s = focusedView({halfPlane(8, 20, 1), halfPlane(3, -0.2, 1)});
  s.instances[1].color = {1, 0, 0, 1};
  const auto at = [&](float focus, float x) {
    s.settings.camera.focus = focus, s.settings.camera.focusX = x;
    return test::trace(s).image.color;
  };
  EXPECT_EQ(at(0, 0.5f), at(8, 0));
  EXPECT_EQ(at(0, 0.1f), at(3, 0));
  EXPECT_NE(at(0, 0.1f), at(8, 0));
  // Nothing at the position: the middle of the bounds.
  s.instances.pop_back();
  s.instances[0].mesh = halfPlane(8, -1, 1);
  EXPECT_EQ(at(0, 0.9f), at(8, 0));
}

TEST(Lens, IsTheSameWithAnyNumberOfThreads) {
  scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
  s.settings.spp = 16;
  s.settings.threads = 1;
  const Image one = test::trace(s).image;
  s.settings.threads = 4;
  EXPECT_EQ(one.color, test::trace(s).image.color);
}

TEST(Lens, TakesEnoughSamples) {
  scene::Snapshot s = focusedView({halfPlane(20, 0.1, 1)});
  s.settings.spp = 1;
  const Image few = test::trace(s).image;
  s.settings.spp = 16;
  EXPECT_EQ(few.color, test::trace(s).image.color);
}

TEST(Lens, InMultisampledFramebuffersPixelsAverage) {
  scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
  const Image plain = test::trace(s).image;
  s.samples = 4;
  s.samplePositions = {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};
  const Image image = test::trace(s).image;
  EXPECT_EQ(image.samples, 1);
  EXPECT_EQ(image.color, plain.color);
}

TEST(Lens, CullsByWhatEachRaySees) {
  // The right side of this slab, edge-on to the viewpoint, faces the right half of the lens only.
  test::MeshData data = test::quadData({0, -9, -3}, {0, -9, -8}, {0, 9, -8}, {0, 9, -3});
  scene::Snapshot s = focusedView({test::makeMesh(data)});
  s.settings.camera.focus = 3;
  const auto sum = [&](scene::CullFace cull) {
    s.instances[0].cull = cull;
    double sum = 0;
    for (const uint32_t c : test::trace(s).image.color) sum += c >> 24;
    return sum;
  };
  const double both = sum(scene::CullFace::none), front = sum(scene::CullFace::back),
               back = sum(scene::CullFace::front);
  EXPECT_GT(both, 0);
  EXPECT_NEAR(front / both, 0.5, 0.02);
  EXPECT_NEAR(front + back, both, 1 + 0.001 * both);
}

TEST(Lens, AbsurdLensesDoNoHarm) {
  for (const float aperture : {1e-30f, 1e10f, 1e30f}) {
    for (const float focus : {1e-30f, 1e30f}) {
      scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
      s.settings.spp = 16;
      s.settings.camera.aperture = aperture, s.settings.camera.focus = focus;
      const test::Traced traced = test::trace(s);
      EXPECT_EQ(traced.image.color.size(), size_t{kEdgeSize} * kEdgeSize);
    }
  }
  for (const float number : {1e-30f, 1000.0f}) {
    for (const float film : {1e-30f, 1e30f}) {
      scene::Snapshot s = focusedView({halfPlane(8, 0.1, 1)});
      s.settings.spp = 16;
      s.settings.camera.fNumber = number, s.settings.camera.film = film;
      EXPECT_EQ(test::trace(s).image.color.size(), size_t{kEdgeSize} * kEdgeSize);
    }
  }
}

}  // namespace
}  // namespace gluray::render
