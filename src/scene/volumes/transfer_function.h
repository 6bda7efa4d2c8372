// Transfer functions of a volume, and how a channel of its voxels is read with them. Plain data.
#pragma once
#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace gluray::scene {

/// A transfer function: values at the centres of equal parts of 0 .. 1, clamped to its ends.
struct VolumeTable {
  std::vector<float> values;  // as many as entries times channels
  int channels = 1;           // 1, or 3: red, green, blue; 4: and opacity
  bool linear = true;         // between centres; false: the nearest one
  int entries() const { return static_cast<int>(values.size()) / channels; }
  bool operator==(const VolumeTable&) const = default;
};

/// A transfer function of two coordinates, each 0 .. 1, at the centres of equal parts, clamped to its edges.
struct VolumeTable2D {
  glm::ivec2 size{0};
  std::vector<glm::vec4> values;  // red, green, blue, opacity; x fastest
  bool linear = true;             // between centres; false: the nearest one
  bool operator==(const VolumeTable2D&) const = default;
};

/// How light is reflected.
struct VolumeMaterial {
  glm::vec3 ambient{0}, diffuse{0}, specular{0};
  float shininess = 1;
};

/// One channel of the voxels, and its look.
struct VolumeChannel {
  float scale = 1, bias = 0;                           // from a texture's value to the scalar
  glm::vec2 range{0, 1};                               // values of data for scalars 0 and 1
  VolumeTable opacity, color;                          // read at the scalar; opacity of a step
  std::shared_ptr<const VolumeTable> gradientOpacity;  // by the gradient's length; null: none
  VolumeMaterial material;
  float weight = 1;  // of its colour among those of several channels
};

}  // namespace gluray::scene
