// Volumes of constant opacity, for the tests of the light that volumes block and get.
#pragma once
#include "accel/testing/test_grids.h"
#include "render/testing/test_volume_view.h"
#include "scene/volumes/placed_volume.h"

#include <cmath>
#include <memory>

namespace gluray::test {

inline constexpr float kFogStep = 0.05f;

/// A box from -1 to 1 along each axis of data space, whose extinction is `extinction`. value(voxel) is 1
/// where there is fog.
template <class Value>
scene::Medium fogOf(float extinction, const Value& value, int voxels = 16) {
  const VolumeBox box{.voxels = glm::ivec3(voxels)};
  scene::Medium medium;
  const auto grid = makeGrid(scene::VoxelGrid::Type::single, box.voxels);
  eachVoxel(grid->size, [&](const glm::ivec3& voxel) { store(*grid, voxel, value(voxel)); });
  scene::Volume& volume = medium.volume;
  volume.grid = grid;
  volume.linear = false;
  volume.channels[0].opacity.values = {0, 1 - std::exp(-extinction * kFogStep)};
  volume.channels[0].opacity.linear = false;
  volume.channels[0].color.channels = 3, volume.channels[0].color.values = {1, 1, 1};
  volume.cellStep = glm::vec3(1.0f / static_cast<float>(voxels));
  volume.cellSpacing = glm::vec3(2.0f / static_cast<float>(voxels));
  // The faces of the box are the outer faces of voxels.
  medium.textureFromData =
      glm::scale(glm::dmat4(1), glm::dvec3(0.5)) * glm::translate(glm::dmat4(1), glm::dvec3(1));
  medium.step = kFogStep;
  return medium;
}

inline scene::Medium fog(float extinction, int voxels = 16) {
  return fogOf(
      extinction, [](const glm::ivec3&) { return 1.0; }, voxels);
}

inline scene::PlacedVolume placed(scene::Medium medium, const glm::dmat4& eyeFromData = glm::dmat4(1)) {
  return {std::make_shared<const scene::Medium>(std::move(medium)), eyeFromData};
}

}  // namespace gluray::test
