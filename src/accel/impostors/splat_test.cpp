// Gaussian splats: their billboards, their fall-off, and bounds that hold both.
#include "accel/impostors/pixel_impostor.h"
#include "accel/testing/test_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray::accel {
namespace {

constexpr glm::ivec2 kSplatWindow{100, 100};  // pixels

/// One splat of radius 0.1, which are five pixels in a parallel view at its centre.
struct SplatScene {
  scene::Camera camera;
  scene::Instance instance;
  PlacedImpostors placed;

  explicit SplatScene(const glm::vec3& at, bool parallel = true, const glm::dmat4& turned = glm::dmat4(1)) {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->shape = scene::Shape::splats;
    mesh->vertexCount = mesh->triangleCount = 1;
    mesh->lower = mesh->upper = at, mesh->radius = 0.1f;
    mesh->positions = test::makeAttribute(std::vector<glm::vec3>{at}, scene::Format::float3);
    instance.mesh = mesh;
    instance.eyeFromObject = turned, instance.lightingFromObject = glm::mat4(turned);
    camera.viewport = {0, 0, kSplatWindow};
    camera.clipFromEye = parallel ? glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 20.0)
                                  : glm::perspective(glm::radians(60.0), 1.0, 1.0, 20.0);
    scene::Impostors& f = instance.impostors;
    f.gaussian = true, f.billboardScale = 3, f.parallelView = parallel;
    f.size = glm::vec2(camera.clipFromEye[0][0], camera.clipFromEye[1][1]);
    placed = PlacedImpostors(instance, camera);
    placed.window = windowVertices(placed);
  }
  PixelImpostor splat() const {
    PixelImpostor f(placed, 0);
    f.prepare();
    return f;
  }
  int covered() const {
    const PixelImpostor f = splat();
    int count = 0;
    for (int y = 0; y < kSplatWindow.y; ++y)
      for (int x = 0; x < kSplatWindow.x; ++x) count += f.covers({x + 0.5, y + 0.5});
    return count;
  }
};

TEST(GaussianSplat, CoversASquareOfThreeRadiiAndFallsOffAsAGaussian) {
  const SplatScene s({0, 0, -5});
  EXPECT_EQ(s.covered(), 30 * 30);
  const PixelImpostor f = s.splat();
  EXPECT_TRUE(f.covers({35.5, 35.5}));
  EXPECT_FALSE(f.covers({34.5, 35.5}));
  PixelImpostor::Shown shown;
  for (const double radii : {0.0, 1.0, 2.5}) {
    ASSERT_TRUE(f.show({50 + 5 * radii, 50}, shown));
    EXPECT_NEAR(shown.alpha, std::exp(-0.5 * radii * radii), 1e-6);
  }
}

TEST(GaussianSplat, HasABillboardAlongTheAxesOfItsEllipse) {
  const glm::dmat4 turned =
      glm::rotate(glm::dmat4(1), glm::radians(30.0), {0, 0, 1}) * glm::scale(glm::dmat4(1), {3, 1, 1});
  const SplatScene s(glm::vec3(0, 0, -5), true, turned);
  EXPECT_NEAR(s.covered(), 3 * 30 * 30, 30);
  const PixelImpostor f = s.splat();
  const auto at = [](double along, double across) {
    const double c = std::cos(glm::radians(30.0)), n = std::sin(glm::radians(30.0));
    return glm::dvec2(50 + c * along - n * across, 50 + n * along + c * across);
  };
  EXPECT_TRUE(f.covers(at(44, 14)) && f.covers(at(-44, 14)));
  EXPECT_FALSE(f.covers(at(46, 0)) || f.covers(at(0, 16)));
  PixelImpostor::Shown shown;
  ASSERT_TRUE(f.show(at(15, 0), shown));
  EXPECT_NEAR(shown.alpha, std::exp(-0.5), 1e-4);
}

/// As f3d's shader computes it: opacity falls to 0 within what the distance changes by over a block of
/// pixels.
TEST(AntialiasedSplat, HasAnEdgeOfAPixel) {
  SplatScene s({0, 0, -5});
  s.instance.impostors.gaussian = false, s.instance.impostors.antialiased = true;
  s.placed.look = s.instance.impostors;
  const PixelImpostor f = s.splat();
  PixelImpostor::Shown shown;
  ASSERT_TRUE(f.show({52.5, 50.5}, shown));
  EXPECT_NEAR(shown.fade, 1 - std::hypot(2.5, 0.5) / 5, 1e-6);
  EXPECT_EQ(shown.alpha, 1);
  ASSERT_TRUE(f.show({55.5, 50.5}, shown));
  EXPECT_EQ(shown.fade, 0);
  const double width =
      (std::hypot(5.5, 0.5) - std::hypot(4.5, 0.5) + std::hypot(5.5, 1.5) - std::hypot(5.5, 0.5)) / 5;
  const double t = (std::hypot(5.5, 0.5) / 5 - 1) / width;
  EXPECT_NEAR(shown.alpha, 1 - t * t * (3 - 2 * t), 1e-6);
  EXPECT_FALSE(f.show({56.5, 50.5}, shown)) << "transparent";
}

/// Of a ring two widths wide each side has one, within the ellipse and outside.
TEST(AntialiasedSplat, MayBeAnOutline) {
  SplatScene s({0, 0, -5});
  s.instance.impostors.gaussian = false, s.instance.impostors.antialiased = true;
  s.instance.impostors.outline = 2;
  s.placed.look = s.instance.impostors;
  const PixelImpostor f = s.splat();
  PixelImpostor::Shown shown;
  const auto expectAlpha = [&](double x, double width) {
    ASSERT_TRUE(f.show({50 + x, 50.5}, shown)) << x;
    const double t = std::abs(std::hypot(x, 0.5) / 5 - 1) / (2 * width);
    EXPECT_NEAR(shown.alpha, 1 - t * t * (3 - 2 * t), 1e-6) << x;
    EXPECT_EQ(shown.fade, 1);
  };
  const auto widthOf = [](double x) {  // of the block whose pixels are at x and x + 1
    return [x](double at) {
      return (std::hypot(x + 1, 0.5) - std::hypot(x, 0.5) + std::hypot(at, 1.5) - std::hypot(at, 0.5)) / 5;
    };
  };
  expectAlpha(5.5, widthOf(4.5)(5.5));
  expectAlpha(3.5, widthOf(2.5)(3.5));
  expectAlpha(2.5, widthOf(2.5)(2.5));
  EXPECT_FALSE(f.show({51.5, 50.5}, shown)) << "transparent";
  EXPECT_FALSE(f.show({57.5, 50.5}, shown)) << "transparent";
}

/// Rays through the corners of the billboard meet the bounding box.
TEST(GaussianSplat, IsWithinItsBounds) {
  for (const bool parallel : {true, false})
    for (const float x : {0.0f, 0.7f}) {
      const SplatScene s({x, 0.4f, -3}, parallel);
      const Box box = boundsOfImpostor(*s.instance.mesh, reachOf(s.instance, s.camera), 0);
      const PixelImpostor f = s.splat();
      const double w = parallel ? 1 : 3;
      const glm::dvec2 perPixel =
          2.0 * w / (glm::dvec2(s.instance.impostors.size) * glm::dvec2(kSplatWindow));
      for (int py = 0; py < kSplatWindow.y; ++py)
        for (int px = 0; px < kSplatWindow.x; ++px) {
          if (!f.covers({px + 0.5, py + 0.5})) continue;
          const glm::dvec2 eye = (glm::dvec2(px + 0.5, py + 0.5) - 0.5 * glm::dvec2(kSplatWindow)) * perPixel;
          EXPECT_TRUE(eye.x >= box.lower.x && eye.x <= box.upper.x && eye.y >= box.lower.y &&
                      eye.y <= box.upper.y)
              << eye.x << " " << eye.y;
        }
    }
}

}  // namespace
}  // namespace gluray::accel
