// Lighting state of a draw, prepared for the kernels. Made once per frame, read by every tracing thread.
#pragma once
#include "scene/shading.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::render {

/// One light. Vectors are in eye space.
struct PreparedLight {
  glm::vec3 ambient, diffuse, specular;
  glm::vec3 position;    // positional light: position; directional light: unit vector towards it
  glm::vec3 halfVector;  // directional light, viewer at infinity: unit half vector
  bool directional = true;
  bool attenuated = false, spot = false;
  glm::vec3 attenuation{1, 0, 0};
  glm::vec3 spotDirection{0, 0, -1};  // unit
  float spotCosCutoff = -1, spotExponent = 0;
  bool specularOn = false;  // its specular colour is not black
};

/// scene::Shading with its lights prepared.
struct Lighting {
  const scene::Shading* shading = nullptr;
  std::vector<PreparedLight> lights;
  std::vector<float> coneCosines;  // of the lights of a fragment program
  glm::vec3 globalAmbient{0};
  bool needsPosition = false;  // the equation uses the eye-space position
  explicit Lighting(const scene::Shading&);
};

}  // namespace gluray::render
