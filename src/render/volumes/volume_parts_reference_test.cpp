// Channels, lights and parts of traced volumes equal a plain loop over all samples, with every instruction
// set.
#include "render/testing/random_volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace gluray::render {
namespace {

using namespace test;
using scene::VolumeBlend;

/// Gives a cast several channels.
void setChannels(Random& random, RandomCast& made, scene::VolumeChannels use) {
  using Use = scene::VolumeChannels;
  scene::Volume& volume = made.cast.volume;
  const int channels = use == Use::colorAndOpacity ? 2 : use == Use::colors ? 4 : random.integer(2, 4);
  const auto grid = makeGrid(volume.grid->type, volume.grid->size, channels);
  fillRandomly(*grid, random, -0.2, 1.2);
  volume.grid = grid, volume.use = use;
  if (use != Use::independent) volume.gradientChannel = static_cast<size_t>(random.integer(0, channels - 1));
  const scene::VolumeChannel first = volume.channels[0];
  volume.channels.assign(static_cast<size_t>(channels), first);
  for (scene::VolumeChannel& channel : volume.channels) {
    channel.opacity = randomTable(random, 1, true), channel.color = randomTable(random, 3, true);
    for (float& a : channel.opacity.values) a *= 0.3f;
    channel.weight = random.integer(0, 5) == 0 ? 0 : static_cast<float>(random.real(0.1, 1));
    channel.range = {random.real(-3, 0), random.real(1, 5)};
  }
}

TEST(VolumeReference, MixesChannelsAsAPlainLoop) {
  using Use = scene::VolumeChannels;
  for (const Use use : {Use::independent, Use::colorAndOpacity, Use::colors})
    expectReferences(
        8, 0.25,
        [&](Random& random, RandomCast& made) {
          setChannels(random, made, use);
          if (use == Use::independent) setBlend(random, made.cast.volume);
          const VolumeBlend blend = made.cast.volume.blend;
          if (blend == VolumeBlend::average || blend == VolumeBlend::additive)  // which have no colours
            for (scene::VolumeChannel& channel : made.cast.volume.channels) channel.color = {};
          if (random.integer(0, 1) == 1) addLight(random, made.cast.volume);
          if (random.integer(0, 2) == 0)
            for (scene::VolumeChannel& channel : made.cast.volume.channels)
              channel.gradientOpacity = std::make_shared<scene::VolumeTable>(randomTable(random, 1, true));
        },
        20);
}

TEST(VolumeReference, LightsByAllLightsAsAPlainLoop) {
  expectReferences(9, 0.25, [](Random& random, RandomCast& made) {
    addLights(random, made.cast.volume);
    if (random.integer(0, 2) == 0)
      made.cast.volume.channels[0].gradientOpacity =
          std::make_shared<scene::VolumeTable>(randomTable(random, 1, true));
  });
}

TEST(VolumeReference, SkipsSamplesAsAPlainLoop) {
  expectReferences(10, 0.25, [](Random& random, RandomCast& made) {
    scene::Volume& volume = made.cast.volume;
    setBlend(random, volume);
    volume.averaged = {-10, 10};
    if (random.integer(0, 2) > 0) {
      auto cropping = std::make_shared<scene::VolumeCropping>();
      for (size_t i = 0; i < 6; ++i)
        cropping->planes[i] = static_cast<float>(i % 2 == 0 ? random.real(0, 0.5) : random.real(0.5, 1));
      for (bool& kept : cropping->kept) kept = random.integer(0, 1) == 1;
      volume.cropping = cropping;
    }
    if (random.integer(0, 2) == 0) return;
    const auto mask = makeGrid(scene::VoxelGrid::Type::byte, random.size(1, 9));
    eachVoxel(mask->size, [&](const glm::ivec3& voxel) {
      store(*mask, voxel, random.integer(0, 2) == 0 ? 0 : random.integer(1, 255));
    });
    volume.mask = mask;
  });
}

TEST(VolumeReference, ClipsRaysAsAPlainLoop) {
  expectReferences(11, 0.1, [](Random& random, RandomCast& made) {
    setBlend(random, made.cast.volume);
    if (random.integer(0, 1) == 1) addDepths(random, made.cast.view);
    std::vector<glm::dvec4> planes;
    for (int i = random.integer(1, 4); i > 0; --i) {
      const glm::dvec3 normal = glm::normalize(random.point(-1, 1));
      planes.emplace_back(normal, -glm::dot(normal, random.point(-0.5, 0.5)) + 0.2);
    }
    clip(made.cast.view, planes);
  });
}

TEST(VolumeReference, FindsIsosurfacesAsAPlainLoop) {
  expectReferences(12, 0.1, [](Random& random, RandomCast& made) {
    scene::Volume& volume = made.cast.volume;
    volume.blend = VolumeBlend::isosurface;
    for (int i = random.integer(1, 4); i > 0; --i)
      volume.contours.push_back(static_cast<float>(random.real(-0.1, 1.1)));
    std::sort(volume.contours.begin(), volume.contours.end());
    if (random.integer(0, 1) == 1) addLight(random, volume);
    if (random.integer(0, 3) == 0) volume.linear = false;
  });
}

}  // namespace
}  // namespace gluray::render
