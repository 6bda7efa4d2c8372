// Random volumes, lights and views for the tests of render/volumes, and their comparison with the plain loop
// of reference_volume.h.
#pragma once
#include "accel/testing/test_grids.h"
#include "render/testing/reference_volume.h"
#include "render/testing/test_targets.h"
#include "render/testing/test_volume_view.h"
#include "render/volumes/volume_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::test {

inline constexpr double kTolerance = 1e-4;  // colours of 0 to 1: rounding of floats

inline scene::VolumeTable randomTable(Random& random, int channels, bool linear) {
  scene::VolumeTable table;
  table.channels = channels, table.linear = linear;
  const int entries = random.integer(1, 24), zeros = random.integer(0, entries / 2);
  for (int i = 0; i < entries; ++i)
    for (int c = 0; c < channels; ++c) {
      const double value = random.real();
      table.values.push_back(channels == 1 && i < zeros ? 0.0f : static_cast<float>(value));
    }
  return table;
}

/// A random volume whose scalars lie in and somewhat around 0 .. 1.
inline scene::Volume randomVolume(Random& random, scene::VoxelGrid::Type type, const VolumeBox& box) {
  scene::Volume volume;
  const auto grid = makeGrid(type, box.voxels);
  fillRandomly(*grid, random, -0.2, 1.2);
  // Empty space beside it.
  const glm::ivec3 end = grid->size / 2;
  if (random.integer(0, 1) == 1) eachVoxel(end, [&](const glm::ivec3& voxel) { store(*grid, voxel, 0); });
  volume.grid = grid;
  const bool inverted = random.integer(0, 3) == 0;
  volume.channels[0].scale = inverted ? -1 : 1, volume.channels[0].bias = inverted ? 1 : 0;
  volume.channels[0].opacity = randomTable(random, 1, true);
  // More steps with less opacity reach the voxels behind.
  const double dim = random.real(0.05, 0.6);
  for (float& a : volume.channels[0].opacity.values) a *= static_cast<float>(dim);
  volume.channels[0].color = randomTable(random, 3, true);
  volume.cellStep = 1.0f / glm::vec3(box.voxels);
  volume.cellSpacing = glm::vec3(box.upper - box.lower) / glm::vec3(glm::max(box.voxels - 1, 1));
  volume.channels[0].range = {random.real(-3, 0), random.real(1, 5)};
  volume.averaged = {-10, 10};
  return volume;
}

inline void addMaterials(Random& random, scene::Volume& volume) {
  for (scene::VolumeChannel& channel : volume.channels) {
    scene::VolumeMaterial& material = channel.material;
    material.ambient = random.point(0, 0.3), material.diffuse = random.point(0.2, 0.9);
    material.specular = random.point(0, 0.5), material.shininess = static_cast<float>(random.real(1, 20));
    if (random.integer(0, 1) == 1) material.shininess = std::round(material.shininess);
  }
}

inline void addLight(Random& random, scene::Volume& volume) {
  scene::VolumeShading& shading = volume.shading;
  using Model = scene::VolumeShading::Model;
  shading.twoSided = random.integer(0, 1) == 1;
  shading.model =
      shading.twoSided && random.integer(0, 1) == 1 ? Model::viewerHalfway : Model::viewerReflected;
  shading.lights.resize(1);
  shading.lights[0].diffuse = random.point(0.5, 1), shading.lights[0].specular = random.point(0.5, 1);
  addMaterials(random, volume);
}

inline void addLights(Random& random, scene::Volume& volume) {
  scene::VolumeShading& shading = volume.shading;
  using Model = scene::VolumeShading::Model;
  shading.model = random.integer(0, 2) == 0 ? Model::lightsHalfway : Model::lightsReflected;
  shading.twoSided = random.integer(0, 1) == 1;
  shading.eyeFromTexture = glm::translate(glm::mat4(1), glm::vec3(random.point(-1, 1)) - glm::vec3(0, 0, 4));
  shading.eyeFromTexture = glm::rotate(shading.eyeFromTexture, 0.7f, glm::vec3(1, 2, 3));
  shading.eyeFromGradient = glm::mat3(shading.eyeFromTexture);
  for (int i = random.integer(1, 4); i > 0; --i) {
    scene::VolumeLight& light = shading.lights.emplace_back();
    light.ambient = random.point(0, 0.3), light.diffuse = random.point(), light.specular = random.point();
    light.direction = glm::normalize(random.point(-1, 1));
    light.positional = random.integer(0, 1) == 1;
    light.position = random.point(-3, 3), light.attenuation = random.point(0.1, 1);
    light.coneAngle = random.integer(0, 1) == 1 ? 180.0f : static_cast<float>(random.real(20, 90));
    light.exponent = static_cast<float>(random.real(0, 4));
  }
  addMaterials(random, volume);
}

struct RandomCast {
  VolumeBox box;
  scene::VolumeCast cast;
};

/// A random view of a random volume.
inline RandomCast randomCast(Random& random, scene::VoxelGrid::Type type, int most) {
  RandomCast made;
  made.box.voxels = random.size(1, most);
  made.box.lower = random.point(-1.2, -0.4), made.box.upper = random.point(0.4, 1.2);
  made.cast.volume = randomVolume(random, type, made.box);
  VolumeCamera camera;
  const bool inside = random.integer(0, 5) == 0;
  camera.pixels = {random.integer(1, 30), random.integer(1, 20)};
  camera.eye = inside ? random.point(-0.3, 0.3) : glm::normalize(random.point(-1, 1)) * random.real(3, 8);
  camera.target = inside ? camera.eye + random.point(-1, 1) : random.point(-0.3, 0.3);
  if (inside) camera.near = 0.02;
  camera.parallel = !inside && random.integer(0, 1) == 1;
  camera.height = camera.parallel ? 2.5 : 0.7;
  made.cast.view = viewOf(camera, made.box, random.real(0.03, 0.2), inside);
  return made;
}

/// Depths of what stands in the volume.
inline void addDepths(Random& random, scene::VolumeView& view) {
  for (int p = 0; p < view.region.width * view.region.height; ++p) {
    const glm::dvec4 window = view.windowFromData * glm::dvec4(random.point(-1.5, 1.5), 1);
    const bool open = random.integer(0, 2) == 0;
    view.depth.push_back(open ? 1.0f : static_cast<float>(std::clamp(window.z / window.w, 0.0, 1.0)));
  }
}

using ReferencePixels = std::vector<ReferencePixel>;

inline ReferencePixels referenceOf(const RandomCast& made) {
  ReferencePixels pixels;
  ReferenceVolume reference(made.cast, made.box);
  for (int y = 0; y < made.cast.view.region.height; ++y)
    for (int x = 0; x < made.cast.view.region.width; ++x) pixels.push_back(reference.at(x, y));
  return pixels;
}

/// Compares a traced image with the reference. `depths`: how much depths may differ.
inline void expectReference(const RandomCast& made, const ReferencePixels& reference, Arena& arena,
                            double depths = 1e-6) {
  render::VolumeTracer tracer;
  Image image;
  const char* why = "";
  ASSERT_TRUE(tracer.trace(made.cast, arena, image, why)) << why;
  ASSERT_EQ(image.depth.size(), reference.size());
  for (size_t i = 0; i < reference.size(); ++i) {
    const ReferencePixel& expected = reference[i];
    if (expected.unsure) continue;
    const size_t x = i % static_cast<size_t>(image.width), y = i / static_cast<size_t>(image.width);
    EXPECT_EQ(image.depth[i] != Image::kMiss, expected.shown) << x << " " << y;
    EXPECT_NEAR(double{image.depth[i]}, expected.depth, depths) << x << " " << y;
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(double{image.wideColor[4 * i + static_cast<size_t>(c)]}, expected.color[c], kTolerance)
          << "pixel " << x << " " << y << ", channel " << c;
  }
}

/// How many of all pixels show something, and how many cannot be compared.
struct Seen {
  size_t pixels = 0, shown = 0, unsure = 0;
  void add(const ReferencePixels& reference) {
    for (const ReferencePixel& pixel : reference) ++pixels, shown += pixel.shown, unsure += pixel.unsure;
  }
};

/// Calls change(random, made) on random casts of all types of voxels and compares each with the reference.
template <class Change>
void expectReferences(unsigned seed, double mostUnsure, const Change& change, int voxels = 40) {
  constexpr int kRounds = 30;
  Arena arena(2);
  Random random(seed);
  Seen seen;
  for (int round = 0; round < kRounds; ++round)
    for (const scene::VoxelGrid::Type type : kVoxelTypes) {
      RandomCast made = randomCast(random, type, voxels);
      change(random, made);
      const ReferencePixels reference = referenceOf(made);
      seen.add(reference);
      withEachTarget([&](int64_t target) {
        const glm::ivec3& size = made.box.voxels;
        SCOPED_TRACE(::testing::Message()
                     << "round " << round << ", type " << static_cast<int>(type) << ", voxels " << size.x
                     << " " << size.y << " " << size.z << ", target " << target);
        expectReference(made, reference, arena);
      });
      if (::testing::Test::HasFailure()) return;
    }
  EXPECT_GT(seen.shown, seen.pixels / 6);
  EXPECT_LE(static_cast<double>(seen.unsure), mostUnsure * static_cast<double>(seen.pixels));
}

inline void setBlend(Random& random, scene::Volume& volume) {
  constexpr scene::VolumeBlend kBlends[] = {scene::VolumeBlend::composite, scene::VolumeBlend::maximum,
                                            scene::VolumeBlend::minimum, scene::VolumeBlend::average,
                                            scene::VolumeBlend::additive};
  volume.blend = kBlends[random.integer(0, 4)];
}

}  // namespace gluray::test
