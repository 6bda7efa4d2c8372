// The extinction of volumes, and the light that they block.
#include "render/volume_light/medium.h"

#include "render/testing/test_fog.h"
#include "render/testing/test_trace.h"
#include "render/tile_tracer.h"
#include "scene/secondary_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace gluray::render {
namespace {

using test::fog;
using test::fogOf;

std::shared_ptr<const Lattice> extinctionIn(const scene::Medium& medium) {
  Arena arena(2);
  return arena.execute([&] { return extinctionOf(medium); });
}

TEST(Medium, LatticesHaveWholeVoxelsInTheirCells) {
  EXPECT_EQ(latticeSizeOf({1, 1, 1}), glm::ivec3(1));
  EXPECT_EQ(latticeSizeOf({64, 64, 64}), glm::ivec3(64));
  EXPECT_EQ(latticeSizeOf({256, 256, 256}), glm::ivec3(64));
  EXPECT_EQ(latticeSizeOf({1000, 3, 10}), glm::ivec3(1000, 3, 10));
  const glm::ivec3 large = latticeSizeOf({2000, 1500, 700});
  EXPECT_LE(int64_t{large.x} * large.y * large.z, 1 << 18);
  EXPECT_GE(int64_t{large.x} * large.y * large.z, 1 << 17);
}

TEST(Medium, ExtinctionIsThatOfTheOpacityOfAStep) {
  for (const int voxels : {1, 5, 16, 80}) {
    const auto lattice = extinctionIn(fog(1.5f, voxels));
    ASSERT_TRUE(lattice);
    for (const float value : lattice->values) ASSERT_NEAR(value, 1.5f, 1e-4f) << voxels;
    EXPECT_NEAR(lattice->mean, 1.5f, 1e-4f);
  }
}

TEST(Medium, EmptyCellsStayEmpty) {
  const auto lattice =
      extinctionIn(fogOf(2, [](const glm::ivec3& voxel) { return voxel.x < 8 ? 0.0 : 1.0; }));
  ASSERT_EQ(lattice->size, glm::ivec3(16));
  for (int x = 0; x < 16; ++x) EXPECT_NEAR(lattice->values[lattice->index({x, 3, 7})], x < 8 ? 0 : 2, 1e-4f);
}

TEST(Medium, WhatIsCutAwayBlocksNothing) {
  scene::Medium cropped = fog(2), clipped = fog(2);
  auto cropping = std::make_shared<scene::VolumeCropping>();
  cropping->planes = {0.5f, 2, -1, 2, -1, 2};
  std::fill(cropping->kept.begin(), cropping->kept.end(), true);
  cropping->kept[12] = false;  // the lower part of x
  cropped.volume.cropping = cropping;
  clipped.clipping.emplace().planes = {{1, 0, 0, -0.5}};
  for (const scene::Medium& medium : {cropped, clipped}) {
    const auto lattice = extinctionIn(medium);
    for (int x = 0; x < 16; ++x)
      EXPECT_NEAR(lattice->values[lattice->index({x, 3, 7})], x < 8 ? 0 : 2, 1e-4f);
  }
}

TEST(Medium, OnlyCompositeVolumesBlockLight) {
  for (const auto blend : {scene::VolumeBlend::maximum, scene::VolumeBlend::additive}) {
    scene::Medium medium = fog(1);
    medium.volume.blend = blend;
    EXPECT_FALSE(extinctionIn(medium));
  }
  scene::Medium lacking = fog(1);
  lacking.volume.channels[0].opacity.values.clear();
  EXPECT_FALSE(extinctionIn(lacking));
}

TEST(Medium, IsKeptWhileItBlocksAlike) {
  Arena arena(1);
  Media media;
  scene::Medium medium = fog(1);
  const auto extinction = [&] { return media.placed(test::placed(medium), glm::dmat4(1), arena).extinction; };
  const auto first = extinction();
  medium.volume.channels[0].color.values = {1, 0, 0};
  EXPECT_EQ(extinction(), first) << "its colour blocks nothing";
  medium.volume.channels[0].opacity.values[1] *= 2;
  const auto denser = extinction();
  EXPECT_NE(denser, first);
  EXPECT_EQ(extinction(), denser);
  EXPECT_GT(media.bytes(), 0u);
  medium.volume.grid = nullptr;
  medium = fog(1);
  extinction();
  EXPECT_EQ(media.bytes(), 16u * 16 * 16 * sizeof(float)) << "what belonged to voxels that are gone is freed";
}

/// A wall z = 0 that fills the view, under a light along -z; fog from z = 0.5 to 2.5 over its right half.
scene::Snapshot foggedWall(float extinction) {
  scene::Snapshot s = test::makeSnapshot({test::parallelogram({0, 0, 0}, {500, 0, 0}, {0, 500, 0})}, 32);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  scene::Instance& wall = s.instances[0];
  wall.eyeFromObject = s.eyeFromWorld;
  wall.materials[0].front.diffuse = wall.materials[0].back.diffuse = glm::vec4(1);
  wall.materials[0].front.ambient = wall.materials[0].back.ambient = {0, 0, 0, 1};
  scene::Shading& shading = s.shadings[0];
  shading.lighting = true, shading.globalAmbient = {0, 0, 0, 1};
  scene::Light light;
  light.diffuse = glm::vec4(1), light.position = {0, 0, 1, 0};
  shading.lights = {light};
  s.settings.shadows.enabled = true, s.settings.shadows.size = 0, s.settings.shadows.strength = 1;
  auto around = std::make_shared<scene::SecondaryScene>();
  around->volumes.push_back(test::placed(fog(extinction), glm::translate(s.eyeFromWorld, {1, 0, 1.5})));
  s.secondaryScene = around;
  return s;
}

test::Traced traced(const scene::Snapshot& s) {
  Arena arena(2);
  accel::World world;
  Media media;
  world.update(s, arena);
  TraceOptions options;
  options.media = media.of(s, arena);
  test::Traced traced;
  traceImage(s, world, arena, traced.image, options);
  return traced;
}

TEST(Medium, CastsShadowsOnSurfacesThroughWhichTheExponentialOfItsLengthPasses) {
  const test::Traced image = traced(foggedWall(0.6f));
  const float through = std::exp(-0.6f * 2);
  EXPECT_NEAR(image.color(26, 16).g, 255 * through, 2) << "behind the fog";
  EXPECT_NEAR(image.color(5, 16).g, 255, 1) << "beside it";
  scene::Snapshot plain = foggedWall(0.6f);
  plain.settings.shadows.enabled = false;
  EXPECT_NEAR(traced(plain).color(26, 16).g, 255, 1) << "without shadows";
}

TEST(Medium, LightsPathsThatPassIt) {
  scene::Snapshot s = foggedWall(0.6f);
  s.settings.integrator = LightIntegrator::path;
  const test::Traced image = traced(s);
  const float beside = image.color(5, 16).g;
  EXPECT_GT(beside, 100);
  EXPECT_LT(image.color(26, 16).g, 0.75f * beside);
}

TEST(Medium, OccludesSurfacesNearIt) {
  scene::Snapshot s = foggedWall(20);
  s.shadings[0].lighting = false;
  s.settings.shadows.enabled = false;
  s.settings.ao.enabled = true, s.settings.ao.samples = 64, s.settings.ao.distance = 3;
  const test::Traced image = traced(s);
  EXPECT_LT(image.color(26, 16).g, 0.5f * image.color(2, 16).g);
}

}  // namespace
}  // namespace gluray::render
