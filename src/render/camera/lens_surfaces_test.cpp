// Depth of field of all kinds of surfaces: layers, clipped ones, impostors, far viewers.
#include "base/sanitized.h"
#include "render/camera/lens.h"
#include "render/testing/test_ball.h"
#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace gluray::render {
namespace {

constexpr int kSurfacesSize = 64;

scene::Snapshot inFocus(const std::vector<scene::MeshPtr>& meshes) {
  scene::Snapshot s = test::makeSnapshot(meshes, kSurfacesSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.settings.camera.aperture = 0.2f;
  s.settings.camera.focus = 5;
  s.settings.spp = 256;
  return s;
}

scene::MeshPtr halfPlane(float depth, float edge) {
  return test::makeMesh(
      test::quadData({-20, -20, -depth}, {edge, -20, -depth}, {edge, 20, -depth}, {-20, 20, -depth}));
}

/// Mean alpha of each column, 0 .. 1.
std::vector<double> columns(const Image& image) {
  std::vector<double> means(kSurfacesSize);
  for (size_t i = 0; i < image.color.size(); ++i)
    means[i % kSurfacesSize] += (image.color[i] >> 24) / 255.0 / kSurfacesSize;
  return means;
}

void expectColumns(const std::vector<double>& got, const std::vector<double>& expected, double factor = 1) {
  for (size_t x = 0; x < kSurfacesSize; ++x) EXPECT_NEAR(got[x], factor * expected[x], 4.0 / 256) << x;
}

TEST(LensSurfaces, OfLayersAreBlurredAlike) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = inFocus({halfPlane(8, 0.1f)});
  const std::vector<double> solid = columns(test::trace(s).image);
  s.instances[0].color.a = 0.5f;
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.assign(kSurfacesSize * kSurfacesSize, -1.0f);
  s.layers = layers;
  expectColumns(columns(test::trace(s).image), solid, 128.0 / 255);
  layers = std::make_shared<scene::Layers>(*layers);
  layers->of = scene::Layers::Of::sums;
  s.layers = layers;
  const Image sums = test::trace(s).image;
  for (size_t x = 0; x < kSurfacesSize; ++x)
    EXPECT_NEAR(sums.transmittance[x], 1 - 0.5 * sums.wideColor[4 * x + 3] / 0.5, 1e-5);
  // What lies behind the opaque surface of a pixel is hidden.
  layers = std::make_shared<scene::Layers>(*layers);
  layers->of = scene::Layers::Of::order;
  layers->opaqueDepth.assign(kSurfacesSize * kSurfacesSize, 0.5f);
  s.layers = layers;
  for (const uint32_t color : test::trace(s).image.color) ASSERT_EQ(color, 0u);
}

TEST(LensSurfaces, AreClippedWhereTheyAre) {
  GLURAY_RELEASE_ONLY();
  const std::vector<double> edge = columns(test::trace(inFocus({halfPlane(8, 0.1f)})).image);
  scene::Snapshot s = inFocus({halfPlane(8, 15)});
  s.instances[0].clipPlanes = {{-1, 0, 0, 0.1}};
  expectColumns(columns(test::trace(s).image), edge);  // planes that all instances share cut rays
  s.instances.push_back(s.instances[0]);
  s.instances[1].mesh = halfPlane(500, -400);
  s.instances[1].clipPlanes.clear();
  expectColumns(columns(test::trace(s).image), edge);
}

TEST(LensSurfaces, OfAFarViewer) {
  // The viewer is thousands of radii away: rays start at a sphere about the scene.
  constexpr double kAway = 1e4;
  scene::Snapshot s =
      inFocus({test::makeMesh(test::quadData({-1, -1, 0}, {0.1f, -1, 0}, {0.1f, 1, 0}, {-1, 1, 0}))});
  s.eyeFromWorld = s.instances[0].eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, -kAway});
  const double half = 0.5 / kAway;
  s.camera.clipFromEye = glm::perspective(2 * std::atan(half), 1.0, kAway - 10, kAway + 10);
  s.settings.camera.focus = static_cast<float>(kAway * 0.5);
  s.settings.camera.aperture = 0.1f;  // a disc of radius 0.1 at the surface: 6.4 pixels
  const std::vector<double> got = columns(test::trace(s).image);
  for (int x = 0; x < kSurfacesSize; ++x) {
    double expected = 0;
    for (int k = 0; k < 16; ++k) {
      const double from = std::clamp((0.1 + 0.5 - (x + (k + 0.5) / 16) / kSurfacesSize) / 0.1, -1.0, 1.0);
      expected += ((from * std::sqrt(1 - from * from) + std::asin(from)) / M_PI + 0.5) / 16;
    }
    EXPECT_NEAR(got[static_cast<size_t>(x)], expected, 6.0 / 256) << x;
  }
}

TEST(LensSurfaces, LookAlikeWithEachInstructionSet) {
  std::vector<double> first;
  test::withEachTarget([&](int64_t) {
    const std::vector<double> now = columns(test::trace(inFocus({halfPlane(8, 0.1f)})).image);
    if (first.empty()) first = now;
    for (size_t x = 0; x < kSurfacesSize; ++x) EXPECT_NEAR(now[x], first[x], 0.002);
  });
}

scene::Snapshot impostorView(scene::Shape shape, std::vector<glm::vec3> points) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = shape, mesh->radius = 0.6f;
  mesh->vertexCount = static_cast<uint32_t>(points.size());
  mesh->triangleCount = 1;
  mesh->lower = glm::vec3(-2, -2, -12), mesh->upper = glm::vec3(2, 2, -8);
  mesh->positions = test::makeAttribute(std::move(points), scene::Format::float3);
  mesh->axes = test::makeAttribute<glm::vec3>({{1, 2, 0.5f}}, scene::Format::float3);
  scene::Snapshot s = inFocus({mesh});
  s.instances[0].impostors.axisMatrix = glm::mat3(1);
  s.instances[0].impostors.size = {0.2f, 0.2f};
  return s;
}

TEST(LensSurfaces, ImpostorsSpreadAndKeepTheirLight) {
  GLURAY_RELEASE_ONLY();
  using scene::Shape;
  const std::pair<Shape, std::vector<glm::vec3>> kinds[] = {
      {Shape::spheres, {{0.2f, 0.1f, -10}}},
      {Shape::discs, {{0.2f, 0.1f, -10}}},
      {Shape::cylinders, {{0.2f, 0.1f, -10}}},
      {Shape::beads, {{0.2f, 0.1f, -10}}},
      {Shape::tubes, {{-1, -0.5f, -10}, {1, 0.8f, -10}}}};
  for (const auto& [shape, points] : kinds) {
    scene::Snapshot s = impostorView(shape, points);
    const auto light = [&](float focus) {
      s.settings.camera.focus = focus;
      double sum = 0;
      int lit = 0;
      for (const uint32_t color : test::trace(s).image.color) sum += color >> 24, lit += color != 0 ? 1 : 0;
      return std::pair(sum / 255, lit);
    };
    const auto sharp = light(10), blurred = light(4);
    EXPECT_GT(sharp.first, 20) << static_cast<int>(shape);
    EXPECT_NEAR(blurred.first / sharp.first, 1, 0.04) << static_cast<int>(shape);
    EXPECT_GT(blurred.second, 1.3 * sharp.second) << static_cast<int>(shape);
  }
}

TEST(LensSurfaces, AreOccludedAsWell) {
  // A wall at the side of a floor that faces the viewer, both out of focus.
  scene::Snapshot s = inFocus(
      {halfPlane(8, 15), test::makeMesh(test::quadData({0, -9, -8}, {0, 9, -8}, {0, 9, -7}, {0, -9, -7}))});
  s.settings.spp = 32;
  s.settings.ao.enabled = true;
  s.settings.ao.distance = 1;
  s.settings.ao.samples = 4;
  const Image image = test::trace(s).image;
  const auto red = [&](int x) { return image.color[static_cast<size_t>(32 * kSurfacesSize + x)] & 255; };
  EXPECT_EQ(red(2), 255u);
  EXPECT_LT(red(kSurfacesSize / 2 + 2), 230u);
}

/// A sphere as a mesh and as an impostor.
scene::MeshPtr sphere(const glm::vec3& center, float radius) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = scene::Shape::spheres;
  mesh->vertexCount = mesh->triangleCount = 1;
  mesh->positions = test::makeAttribute<glm::vec3>({center}, scene::Format::float3);
  mesh->radius = radius;
  mesh->lower = center - radius, mesh->upper = center + radius;
  return mesh;
}

TEST(Lens, ShowsHalfSpheresAsSpheres) {
  scene::Snapshot s = inFocus({sphere({1.7f, -1.2f, -5}, 0.8f), halfPlane(6, 20)});
  s.settings.spp = 16;
  s.instances[0].impostors.billboards = scene::Impostors::Billboards::square;
  for (const bool occluded : {false, true}) {
    s.settings.ao.enabled = occluded;
    s.instances[0].impostors.hemispheres = false;
    const Image whole = test::trace(s).image;
    s.instances[0].impostors.hemispheres = true;
    EXPECT_EQ(test::trace(s).image.color, whole.color);
  }
}

TEST(Lens, ShowsImpostorsAsTheirSolids) {
  const glm::vec3 center(0.3f, -0.2f, -9);
  const test::Traced solid = test::trace(inFocus({sphere(center, 1)})),
                     mesh = test::trace(inFocus({test::ballMesh(256, 1, center, false)}));
  int seen = 0;
  for (int y = 0; y < kSurfacesSize; ++y)
    for (int x = 0; x < kSurfacesSize; ++x) {
      seen += solid.color(x, y).a > 0 ? 1 : 0;
      ASSERT_LE(test::difference(solid.color(x, y), mesh.color(x, y)), 4) << x << " " << y;
    }
  EXPECT_GT(seen, 100);
}

}  // namespace
}  // namespace gluray::render
