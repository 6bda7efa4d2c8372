// The light that arrives at the samples of volumes: known answers.
#include "render/volume_light/volume_light.h"

#include "render/testing/test_fog.h"
#include "render/testing/test_trace.h"
#include "render/volume_light/medium.h"
#include "render/volumes/volume_tracer.h"
#include "scene/secondary_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace gluray::render {
namespace {

using test::fog;

/// A view of fog from z = 6, among surfaces.
struct FoggedView {
  scene::Snapshot view;
  VolumeLights lights;

  explicit FoggedView(scene::Medium medium, const std::vector<scene::MeshPtr>& meshes = {},
                      const glm::dmat4& eyeFromData = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -6))) {
    view = test::makeSnapshot(meshes, 16);
    view.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
    view.eyeFromWorld = eyeFromData;
    auto around = std::make_shared<scene::SecondaryScene>();
    around->instances = std::move(view.instances), around->shadings = view.shadings;
    for (scene::Instance& instance : around->instances) instance.eyeFromObject = eyeFromData;
    around->blended.assign(around->instances.size(), 0);
    view.instances.clear(), view.shadings.clear();
    view.secondaryScene = around;
    view.volumes = {test::placed(std::move(medium), eyeFromData)};
  }
  std::shared_ptr<const SampleIllumination> light() {
    Arena arena(2);
    accel::World world;
    Media media;
    world.update(view, arena);
    return lights.arriving({view, view.volumes.front()}, world, media, arena);
  }
};

float at(const std::vector<float>& values, const SampleIllumination& light, const glm::ivec3& cell) {
  return values[static_cast<size_t>((cell.z * light.size.y + cell.y) * light.size.x + cell.x)];
}

TEST(VolumeLight, ChangesNothingWithoutEffects) {
  EXPECT_FALSE(FoggedView(fog(1)).light());
  FoggedView unlit(fog(1));
  unlit.view.settings.shadows.enabled = true;
  EXPECT_FALSE(unlit.light()) << "nothing shades it";
}

FoggedView occluded(scene::Medium medium, const std::vector<scene::MeshPtr>& meshes, float distance) {
  FoggedView fogged(std::move(medium), meshes);
  fogged.view.settings.ao.enabled = true, fogged.view.settings.ao.strength = 1;
  fogged.view.settings.ao.distance = distance;
  return fogged;
}

TEST(VolumeLight, NeitherEvenFogNorFlatFacesAreOccluded) {
  for (const float extinction : {0.1f, 2.0f}) {
    const auto light = occluded(fog(extinction), {}, 0.8f).light();
    ASSERT_TRUE(light);
    EXPECT_NEAR(at(light->occlusion, *light, {8, 8, 8}), 1, 1e-3f) << extinction;
  }
  // Of samples at a face, half of a cell deep and deeper.
  const auto dense = occluded(fog(2), {}, 0.8f).light();
  EXPECT_GT(at(dense->occlusion, *dense, {0, 8, 8}), 0.95f);
  const auto opaque = occluded(fog(20), {}, 0.8f).light();
  EXPECT_GT(at(opaque->occlusion, *opaque, {0, 8, 8}), 0.5f);
}

TEST(VolumeLight, FogInAHoleIsOccludedByItsWalls) {
  // A hole from the middle to the face z = 1, as deep as wide, in dense fog.
  const auto isHole = [](const glm::ivec3& v) {
    return v.z >= 8 && v.x >= 5 && v.x <= 10 && v.y >= 5 && v.y <= 10;
  };
  const auto light =
      occluded(test::fogOf(40, [&](const glm::ivec3& v) { return isHole(v) ? 0.0 : 1.0; }), {}, 2).light();
  const float bottom = at(light->occlusion, *light, {7, 7, 8}),
              rim = at(light->occlusion, *light, {7, 7, 15});
  EXPECT_LT(bottom, 0.6f);
  EXPECT_GT(rim, 0.9f);
  FoggedView half = occluded(fog(2), {}, 2);
  half.view.settings.ao.strength = 0;
  EXPECT_FALSE(half.light()) << "without strength";
}

TEST(VolumeLight, SurfacesOccludeVolumes) {
  const auto opennessAmong = [](const std::vector<scene::MeshPtr>& meshes) {
    const auto light = occluded(fog(0.001f), meshes, 1000).light();
    return at(light->occlusion, *light, {8, 8, 8});
  };
  const scene::MeshPtr below = test::parallelogram({0, -1.5f, 0}, {5000, 0, 0}, {0, 0, 5000}),
                       behind = test::parallelogram({0, 0, -1.5f}, {5000, 0, 0}, {0, 5000, 0}),
                       beside = test::parallelogram({-1.5f, 0, 0}, {0, 0, 5000}, {0, 5000, 0});
  EXPECT_NEAR(opennessAmong({}), 1, 1e-3f);
  EXPECT_NEAR(opennessAmong({below}), 1, 0.01f) << "a surface hides one half, which counts as open";
  EXPECT_NEAR(opennessAmong({below, behind, beside}), 0.5f, 0.2f) << "an eighth of the directions is open";
}

scene::Medium litFog(float extinction) {
  scene::Medium medium = fog(extinction);
  scene::VolumeShading& shading = medium.volume.shading;
  shading.model = scene::VolumeShading::Model::lightsReflected;
  shading.eyeFromTexture =
      glm::mat4(glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -6)) * glm::inverse(medium.textureFromData));
  shading.lights.resize(1);
  shading.lights[0].direction = {1, 0, 0};
  return medium;
}

/// What arrives behind this optical depth.
float arriving(float depth) { return std::min(1.0f, std::exp(1 - depth)); }

TEST(VolumeLight, LightsReachFogThroughTheExponentialOfItsLength) {
  FoggedView fogged(litFog(1.9f));
  fogged.view.settings.shadows.enabled = true, fogged.view.settings.shadows.strength = 1;
  const auto light = fogged.light();
  ASSERT_TRUE(light);
  ASSERT_EQ(light->rows, std::vector<int>{0});
  for (const int x : {0, 3, 8, 15}) {
    const float length = (static_cast<float>(x) + 0.5f) / 8;
    EXPECT_NEAR(at(light->shadows[0], *light, {x, 4, 9}), arriving(1.9f * length), 0.01f) << x;
  }
}

TEST(VolumeLight, PositionalLightsShineFromTheirPlaces) {
  scene::Medium medium = litFog(1.9f);
  medium.volume.shading.lights[0].positional = true;
  medium.volume.shading.lights[0].position = {-1, 0, -6};  // on a face of the box
  FoggedView fogged(std::move(medium));
  fogged.view.settings.shadows.enabled = true, fogged.view.settings.shadows.strength = 1;
  const auto light = fogged.light();
  ASSERT_TRUE(light);
  const float length = glm::length(glm::vec3(8.5f, 0.5f, 0.5f) / 8.0f);
  EXPECT_NEAR(at(light->shadows[0], *light, {8, 8, 8}), arriving(1.9f * length), 0.01f);
}

TEST(VolumeLight, SurfacesCastShadowsIntoVolumes) {
  // A screen at x = -2 in front of the lower half, and a light along x.
  FoggedView fogged(litFog(0.001f), {test::parallelogram({-2, -5, 0}, {0, 5, 0}, {0, 0, 5})});
  fogged.view.settings.shadows.enabled = true, fogged.view.settings.shadows.strength = 1;
  const auto light = fogged.light();
  ASSERT_TRUE(light);
  for (int y = 0; y < 16; ++y)
    EXPECT_NEAR(at(light->shadows[0], *light, {8, y, 8}), y < 8 ? 0 : 1, 0.01f) << y;
}

TEST(VolumeLight, LightsAtTheViewerCastNoShadowsThatAreSeen) {
  scene::Medium medium = litFog(0.7f);
  medium.volume.shading.lights[0].positional = true;
  medium.volume.shading.lights[0].position = {0, 0, 0};
  FoggedView fogged(std::move(medium));
  fogged.view.settings.shadows.enabled = true;
  EXPECT_FALSE(fogged.light());
}

TEST(VolumeLight, RigsAddLightsAndReplaceThoseOfTheProgram) {
  FoggedView fogged(litFog(0.7f));
  fogged.view.settings.lights.rig = LightRig::threePoint;
  fogged.view.settings.shadows.enabled = true;
  const auto light = fogged.light();
  ASSERT_TRUE(light);
  EXPECT_EQ(light->programShare, 0);
  ASSERT_FALSE(light->added.empty());
  EXPECT_GE(light->added[0].row, 0);
  EXPECT_EQ(light->rows, std::vector<int>{-1}) << "no shadows of lights that do not shine";
}

TEST(VolumeLight, OcclusionIsKeptWhileTheCameraMoves) {
  FoggedView fogged(fog(2));
  fogged.view.settings.ao.enabled = true, fogged.view.settings.ao.distance = 0.8f;
  const auto first = fogged.light();
  const glm::dmat4 turned = glm::rotate(fogged.view.eyeFromWorld, 0.5, {0, 1, 0});
  fogged.view.eyeFromWorld = turned, fogged.view.volumes[0].eyeFromData = turned;
  EXPECT_EQ(fogged.light()->occlusion, first->occlusion);
}

/// What a volume of one opaque layer shows under an illumination.
glm::vec4 shown(const SampleIllumination& light, bool shaded) {
  const test::VolumeBox box{.voxels = glm::ivec3(8)};
  scene::VolumeCast cast;
  const auto grid = test::makeGrid(scene::VoxelGrid::Type::single, box.voxels);
  test::eachVoxel(grid->size, [&](const glm::ivec3& voxel) { test::store(*grid, voxel, voxel.x); });
  cast.volume.grid = grid;
  cast.volume.channels[0].opacity.values = {1};
  cast.volume.channels[0].color.channels = 3, cast.volume.channels[0].color.values = {0.5f, 0.4f, 0.2f};
  cast.volume.channels[0].material.diffuse = glm::vec3(1);
  cast.volume.cellStep = glm::vec3(1.0f / 8), cast.volume.cellSpacing = glm::vec3(2.0f / 7);
  if (shaded) {
    cast.volume.shading.model = scene::VolumeShading::Model::lightsReflected;
    cast.volume.shading.lights.resize(1);
    cast.volume.shading.lights[0].direction = {1, 0, 0};
  }
  const test::VolumeCamera camera{.eye = {-4, 0, 0}, .parallel = true, .height = 1, .pixels = {3, 3}};
  cast.view = viewOf(camera, box, 0.1);
  Arena arena(1);
  VolumeTracer tracer;
  Image image;
  const char* why = "";
  EXPECT_TRUE(tracer.trace(cast, arena, image, why, &light)) << why;
  const float* const p = &image.wideColor[16];
  return {p[0], p[1], p[2], p[3]};
}

void expectNear(const glm::vec4& a, const glm::vec4& b) {
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], 1e-4f) << c;
}

TEST(VolumeLight, OccludedSamplesKeepTheirOpacity) {
  SampleIllumination light;
  light.size = {2, 1, 1}, light.upper = glm::vec3(1);
  light.occlusion = {0.5f, 0.5f};
  expectNear(shown(light, false), {0.25f, 0.2f, 0.1f, 1});
}

TEST(VolumeLight, AutomaticExposureKeepsTheBrightness) {
  SampleIllumination light;
  light.size = {2, 1, 1}, light.upper = glm::vec3(1);
  light.occlusion = {0.5f, 0.5f}, light.keepsBrightness = true;
  expectNear(shown(light, false), {0.5f, 0.4f, 0.2f, 1});
  light.occlusion = {0.05f, 0.05f};
  expectNear(shown(light, false), {0.2f, 0.16f, 0.08f, 1});  // at most three stops
}

TEST(VolumeLight, ShadowedLightsDimTheirShareAlone) {
  SampleIllumination light;
  light.size = glm::ivec3(1), light.upper = glm::vec3(1);
  light.shadows = {{0.25f}}, light.rows = {0};
  expectNear(shown(light, true), {0.125f, 0.1f, 0.05f, 1});
  light.rows = {-1};
  expectNear(shown(light, true), {0.5f, 0.4f, 0.2f, 1});
}

TEST(VolumeLight, AddedLightsShineBesideThoseOfTheProgram) {
  SampleIllumination light;
  light.size = glm::ivec3(1), light.upper = glm::vec3(1);
  light.rows = {-1}, light.programShare = 0.5f;
  ShadowedLight& added = light.added.emplace_back();
  added.light.direction = {0.6f, 0.8f, 0}, added.light.diffuse = glm::vec3(0.5f);
  expectNear(shown(light, true), glm::vec4(0.8f * glm::vec3(0.5f, 0.4f, 0.2f), 1));
  light.shadows = {{0.5f}}, added.row = 0;
  expectNear(shown(light, true), glm::vec4(0.65f * glm::vec3(0.5f, 0.4f, 0.2f), 1));
  light.ambient = glm::vec3(0.1f);
  expectNear(shown(light, true), glm::vec4(0.75f * glm::vec3(0.5f, 0.4f, 0.2f), 1));
}

}  // namespace
}  // namespace gluray::render
