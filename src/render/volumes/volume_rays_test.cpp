// The rays of volumes: where they begin, how they go on, and what ends them.
#include "render/volumes/volume_rays.h"

#include "accel/testing/test_grids.h"
#include "render/testing/reference_rays.h"
#include "render/testing/test_volume_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gluray::render {
namespace {

constexpr double kNear = 1e-5;

test::VolumeBox randomBox(test::Random& random) {
  test::VolumeBox box;
  box.voxels = random.size(1, 40);
  box.lower = random.point(-1.5, -0.2), box.upper = random.point(0.2, 1.5);
  return box;
}

test::VolumeCamera randomCamera(test::Random& random) {
  test::VolumeCamera camera;
  camera.eye = glm::normalize(random.point(-1, 1)) * random.real(4, 8);
  camera.target = random.point(-0.3, 0.3);
  camera.parallel = random.integer(0, 1) == 1;
  camera.height = camera.parallel ? random.real(2, 6) : random.real(0.5, 1.2);
  return camera;
}

/// Compares all rays of a view with the reference. Returns how many begin in the volume.
int expectRays(const scene::VolumeView& view, const test::VolumeBox& box) {
  const VolumeRays rays(view);
  int hits = 0, unsure = 0;
  for (int y = 0; y < view.region.height; ++y)
    for (int x = 0; x < view.region.width; ++x) {
      SCOPED_TRACE(testing::Message() << "pixel " << x << " " << y);
      const VolumeRay ray = rays.at(x, y);
      const test::ReferenceRay expected = test::referenceRay(view, box, x, y);
      EXPECT_EQ(ray.samples > 0, expected.hits);
      if (!expected.hits || ray.samples == 0) continue;
      ++hits, unsure += expected.unsure;
      EXPECT_LT(glm::length(glm::dvec3(ray.first) - expected.first), kNear);
      EXPECT_LT(glm::length(glm::dvec3(ray.step) - expected.step), kNear);
      EXPECT_LT(glm::length(glm::dvec3(ray.towardsViewer) - glm::normalize(view.viewer - expected.entry)),
                kNear);
      EXPECT_NEAR(double{ray.depth}, expected.depth, 1e-6);
      EXPECT_TRUE(expected.unsure || ray.samples == expected.samples)
          << ray.samples << " instead of " << expected.samples;
    }
  EXPECT_LE(unsure, hits / 10 + 2);
  return hits;
}

TEST(VolumeRays, BeginAtTheBoxAndEndThere) {
  test::Random random(1);
  for (int i = 0; i < 40; ++i) {
    const test::VolumeBox box = randomBox(random);
    const test::VolumeCamera camera = randomCamera(random);
    const double step = random.real(0.02, 0.4);
    SCOPED_TRACE(testing::Message() << "view " << i);
    EXPECT_GT(expectRays(viewOf(camera, box, step), box), 10);
  }
}

TEST(VolumeRays, BeginAtTheNearPlaneInsideTheBox) {
  test::Random random(2);
  for (int i = 0; i < 10; ++i) {
    test::VolumeBox box;
    box.voxels = random.size(2, 40);
    test::VolumeCamera camera = randomCamera(random);
    camera.eye = random.point(-0.5, 0.5), camera.near = 0.05;
    camera.target = camera.eye + random.point(-1, 1);
    if (camera.parallel) camera.height = 0.4;
    const scene::VolumeView view = viewOf(camera, box, 0.05, true);
    SCOPED_TRACE(testing::Message() << "view " << i);
    EXPECT_EQ(expectRays(view, box), view.region.width * view.region.height);
  }
}

TEST(VolumeRays, EndAtDepths) {
  test::Random random(3);
  for (int i = 0; i < 20; ++i) {
    const test::VolumeBox box = randomBox(random);
    const test::VolumeCamera camera = randomCamera(random);
    scene::VolumeView view = viewOf(camera, box, 0.03);
    const int all = expectRays(view, box);
    for (int p = 0; p < view.region.width * view.region.height; ++p) {
      glm::dvec4 window = view.windowFromData * glm::dvec4(random.point(-1.2, 1.2), 1);
      view.depth.push_back(static_cast<float>(std::clamp(window.z / window.w, 0.0, 1.0)));
    }
    SCOPED_TRACE(testing::Message() << "view " << i);
    EXPECT_LT(expectRays(view, box), all);
  }
}

TEST(VolumeRays, NothingBeginsBehindDepthsOrAtThem) {
  const test::VolumeBox box{.voxels = glm::ivec3(8)};
  const test::VolumeCamera camera{.eye = {0, 0, 4}, .parallel = true, .height = 1};
  scene::VolumeView view = viewOf(camera, box, 0.099);
  const float entry = VolumeRays(view).at(3, 4).depth;
  const auto samplesAt = [&](float depth) {
    view.depth.assign(static_cast<size_t>(view.region.width * view.region.height), depth);
    return VolumeRays(view).at(3, 4).samples;
  };
  EXPECT_EQ(samplesAt(entry), 0);
  EXPECT_EQ(samplesAt(entry - 1e-4f), 0);
  EXPECT_EQ(samplesAt(std::nextafter(entry, 1.0f)), 2)
      << "the way from the first sample back to the end counts";
  EXPECT_EQ(samplesAt(1), 20) << "the box is 20 steps deep";
}

TEST(VolumeRays, RegionsHaveTheRaysOfTheWindow) {
  const test::VolumeBox box{.voxels = {9, 5, 30}};
  const test::VolumeCamera camera{.eye = {2, 1, 3}};
  const scene::VolumeView all = viewOf(camera, box, 0.1);
  scene::VolumeView part = all;
  part.region = {7, 5, 6, 9};
  const VolumeRays rays(all), ofPart(part);
  for (int y = 0; y < part.region.height; ++y)
    for (int x = 0; x < part.region.width; ++x) {
      const VolumeRay a = rays.at(7 + x, 5 + y), b = ofPart.at(x, y);
      EXPECT_TRUE(a.first == b.first && a.step == b.step && a.samples == b.samples && a.depth == b.depth)
          << x << " " << y;
    }
}

/// How many pixels of a view that is full of the volume have no ray.
int gapsIn(const scene::VolumeView& view) {
  const VolumeRays rays(view);
  int gaps = 0;
  for (int y = 0; y < view.region.height; ++y)
    for (int x = 0; x < view.region.width; ++x) gaps += rays.at(x, y).samples == 0;
  return gaps;
}

TEST(VolumeRays, EdgesBetweenFacesHaveNoGaps) {
  test::Random random(4);
  // Pixels whose centres lie on the line between both triangles of a face.
  for (int i = 0; i < 300; ++i) {
    test::VolumeBox box{.voxels = glm::ivec3(8)};
    const double half = random.real(0.5, 2), at = random.real(-5, 5);
    box.lower = glm::dvec3(at - half), box.upper = glm::dvec3(at + half);
    const int pixels = random.integer(5, 40);
    test::VolumeCamera camera{.eye = {at, at, at + random.real(3, 6)}, .target = glm::dvec3(at)};
    camera.parallel = random.integer(0, 1) == 1, camera.pixels = glm::ivec2(pixels), camera.up = {0, 1, 0};
    camera.height = camera.parallel ? 2 * half : 2 * half / (camera.eye.z - at - half);
    camera.height *= 0.99;
    EXPECT_EQ(gapsIn(viewOf(camera, box, 0.1)), 0) << "view " << i;
    EXPECT_EQ(gapsIn(viewOf({.eye = glm::dvec3(at),
                             .target = glm::dvec3(at, at, at - 1),
                             .near = half / 9,
                             .pixels = glm::ivec2(pixels)},
                            box, 0.1, true)),
              0)
        << "view " << i << ", inside";
  }
}

TEST(VolumeRays, FacesOutsideOfTheDepthRangeAreClipped) {
  const test::VolumeBox box{.voxels = glm::ivec3(8)};
  test::VolumeCamera camera{.eye = {0, 0, 4}};
  camera.near = 3.5;  // beyond the front face
  EXPECT_EQ(VolumeRays(viewOf(camera, box, 0.1)).at(12, 10).samples, 0);
  camera.near = 0.1, camera.far = 2.5;
  EXPECT_EQ(VolumeRays(viewOf(camera, box, 0.1)).at(12, 10).samples, 0);
  camera.far = 4;
  EXPECT_GT(VolumeRays(viewOf(camera, box, 0.1)).at(12, 10).samples, 5);
}

TEST(VolumeRays, FacesWithoutAnAreaShowNothing) {
  const test::VolumeBox box{.voxels = glm::ivec3(8)};
  scene::VolumeView view = viewOf({}, box, 0.1);
  view.faces = {{0, 0, 1}, {0, 0, 1}, {0.5, 0, 1}, {-1, 0, 1}, {0, 0, 1}, {1, 0, 1}};
  const VolumeRays rays(view);
  for (int y = 0; y < view.region.height; ++y)
    for (int x = 0; x < view.region.width; ++x) EXPECT_EQ(rays.at(x, y).samples, 0);
}

/// A box from -1 to 1 that is seen along -z, in steps of 0.25.
scene::VolumeView viewAlongZ(const test::VolumeBox& box) {
  return viewOf({.eye = {0, 0, 4}, .up = {0, 1, 0}, .parallel = true, .height = 1, .pixels = {5, 5}}, box,
                0.25);
}

TEST(VolumeRays, EndAndBeginAtClipPlanes) {
  const test::VolumeBox box{.voxels = glm::ivec3(9)};
  const auto ray = [&](const std::vector<glm::dvec4>& planes) {
    scene::VolumeView view = viewAlongZ(box);
    test::clip(view, planes);
    return VolumeRays(view).at(2, 2);
  };
  const auto zOf = [](const VolumeRay& r) { return (double{r.first.z} - 0.5 / 9) / (8.0 / 9) * 2 - 1; };
  const VolumeRay whole = VolumeRays(viewAlongZ(box)).at(2, 2);
  EXPECT_NEAR(zOf(whole), 0.75, 1e-6);
  const VolumeRay begun = ray({{0, 0, -1, 0.4}});  // keeps z < 0.4
  EXPECT_NEAR(zOf(begun), 0.15, 1e-6) << "one step behind the plane";
  const VolumeRay ended = ray({{0, 0, 1, -0.1}});  // keeps z > 0.1
  EXPECT_NEAR(zOf(ended), 0.75, 1e-6);
  EXPECT_EQ(ended.samples, 4) << "a sample behind the plane is taken, as nothing ends the ray before it";
  EXPECT_EQ(ray({{0, 0, 1, -5}}).samples, 0) << "nothing is kept";
  EXPECT_EQ(ray({{0, 0, -1, -0.95}}).samples, 0) << "the first sample would lie behind the box";
  const VolumeRay both = ray({{0, 0, -1, 0.4}, {0, 0, 1, 0.3}});
  EXPECT_NEAR(zOf(both), 0.15, 1e-6);
  EXPECT_LT(both.samples, whole.samples);
}

TEST(VolumeRays, HaveOneSampleOnASlice) {
  const test::VolumeBox box{.voxels = glm::ivec3(9)};
  scene::VolumeView view = viewAlongZ(box);
  view.slice = scene::VolumeSlice{{0, 0, 2, -0.6}, view.textureFromData};
  const VolumeRay ray = VolumeRays(view).at(2, 2);
  EXPECT_EQ(ray.samples, 1);
  EXPECT_NEAR(double{ray.first.z}, 0.5 / 9 + (8.0 / 9) * 1.3 / 2, 1e-6);
  const glm::dvec4 window = view.windowFromData * glm::dvec4(0, 0, 0.3, 1);
  const auto depth = static_cast<float>(window.z / window.w);
  view.depth.assign(25, depth + 1e-4f);
  EXPECT_EQ(VolumeRays(view).at(2, 2).samples, 1);
  view.depth.assign(25, depth - 1e-4f);
  EXPECT_EQ(VolumeRays(view).at(2, 2).samples, 0) << "what ends the ray is in front of the slice";
  view.depth.clear();
  for (const glm::dvec4& plane : {glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, -1.5)}) {
    view.slice->plane = plane;
    EXPECT_EQ(VolumeRays(view).at(2, 2).samples, 0) << "it is not met inside the volume";
  }
}

TEST(VolumeRays, OfTilesAreTheSame) {
  test::Random random(9);
  for (int i = 0; i < 40; ++i) {
    const test::VolumeBox box = randomBox(random);
    test::VolumeCamera camera = randomCamera(random);
    camera.pixels = {90, 70};
    const bool inside = i % 4 == 0;
    if (inside) camera.eye = random.point(-0.1, 0.1), camera.near = 0.02, camera.parallel = false;
    scene::VolumeView view = viewOf(camera, box, 0.1, inside);
    if (i % 3 == 0) view.samplePositions = {{0.125f, 0.375f}, {0.625f, 0.875f}};
    const VolumeRays rays(view);
    for (int y0 = 0; y0 < camera.pixels.y; y0 += kTileSize)
      for (int x0 = 0; x0 < camera.pixels.x; x0 += kTileSize) {
        const Tile tile{x0, y0, std::min(x0 + kTileSize, camera.pixels.x),
                        std::min(y0 + kTileSize, camera.pixels.y)};
        const TileRays ofTile(rays, tile);
        for (int y = tile.y0; y < tile.y1; ++y)
          for (int x = tile.x0; x < tile.x1; ++x) {
            const VolumeRay a = rays.at(x, y), b = ofTile.at(x, y);
            ASSERT_TRUE(a.first == b.first && a.step == b.step && a.samples == b.samples &&
                        a.depth == b.depth && a.coverage == b.coverage)
                << "view " << i << ", pixel " << x << " " << y;
          }
      }
  }
}

}  // namespace
}  // namespace gluray::render
