// How the samples of a volume are lit. Plain data.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::scene {

/// A light that shines on samples. "Eye space" is that of the camera.
struct VolumeLight {
  glm::vec3 ambient{0}, diffuse{1}, specular{1};
  glm::vec3 direction{0, 0, -1};  // eye space: where its rays go, length 1
  bool positional = false;
  glm::vec3 position{0};           // eye space
  glm::vec3 attenuation{1, 0, 0};  // by powers 0, 1, 2 of the distance
  float coneAngle = 180;           // degrees; above 90: no cone
  float exponent = 0;              // of the cosine to the cone's axis
};

struct VolumeShading {
  /// `viewer...`: by one light at the viewer, of which the colours of the first light are used. `lights...`:
  /// by all of them. Highlights are about the reflected light or about the half vector; the latter shine also
  /// where no diffuse light does.
  enum class Model : uint8_t { none, viewerReflected, viewerHalfway, lightsReflected, lightsHalfway };
  Model model = Model::none;
  bool twoSided = false;  // gradients have no sign
  std::vector<VolumeLight> lights;
  glm::mat4 eyeFromTexture{1};
  glm::mat3 eyeFromGradient{1};
  bool enabled() const { return model != Model::none; }
  bool isFromViewer() const { return model == Model::viewerReflected || model == Model::viewerHalfway; }
  bool isHalfway() const { return model == Model::viewerHalfway || model == Model::lightsHalfway; }
};

}  // namespace gluray::scene
