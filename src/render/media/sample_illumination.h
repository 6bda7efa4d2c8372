// The light that arrives at the samples of a volume: ambient occlusion, shadows, and lights that the settings
// add. Plain data, made once a frame, read by every tracing thread.
#pragma once
#include "scene/volumes/volume_shading.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::render {

/// A light, and the row of SampleIllumination::shadows that says how much of it arrives; -1: all.
struct ShadowedLight {
  scene::VolumeLight light;
  int row = -1;
};

/// Numbers at the middles of the cells of a lattice over the volume, x fastest, 0 .. 1; linear between them.
struct SampleIllumination {
  glm::ivec3 size{0};
  glm::vec3 lower{0}, upper{1};             // the lattice, in texture space
  std::vector<float> occlusion;             // what of a sample's colour stays; empty: all
  std::vector<std::vector<float>> shadows;  // what of a light arrives
  std::vector<int> rows;   // of the lights of the volume's own shading: as ShadowedLight::row
  float programShare = 1;  // factor of these lights
  // In the eye space of the snapshot; they shine on volumes with a shading.
  std::vector<ShadowedLight> added;
  glm::vec3 ambient{0};          // a factor of samples' diffuse colours, from all directions
  bool keepsBrightness = false;  // the volume's image is as bright as under its own shading (auto-exposure)
  glm::mat4 eyeFromTexture{1};
  glm::mat3 eyeFromGradient{1};
};

}  // namespace gluray::render
