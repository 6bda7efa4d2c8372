// Volumes as media that block light, placed among the surfaces of their view. Immutable.
#pragma once
#include "scene/volumes/volume.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>

namespace gluray::scene {

/// What blocks light of a volume that is blended as VolumeBlend::composite.
struct Medium {
  Volume volume;
  glm::dmat4 textureFromData{1};
  float step = 1;                // data space: opacities are those of steps of this length
  glm::vec3 lower{0}, upper{1};  // texture space: the medium ends where it leaves this box
  std::optional<VolumeClipping> clipping;
};

/// Whether two media block light alike. Voxels are compared by where they are stored.
bool blockAlike(const Medium& a, const Medium& b);

struct PlacedVolume {
  std::shared_ptr<const Medium> medium;
  glm::dmat4 eyeFromData{1};  // eye space of the snapshot
  bool operator==(const PlacedVolume& other) const;
};

}  // namespace gluray::scene
