// One draw of a volume by a ray caster in a fragment shader, as plain data. Immutable.
#pragma once
#include "scene/region.h"
#include "scene/voxel_grid.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

/// How the samples of a ray become one colour.
enum class VolumeBlend : uint8_t { composite, maximum, minimum, average, additive };

/// A transfer function: values at the centres of equal parts of 0 .. 1, clamped to its ends.
struct VolumeTable {
  std::vector<float> values;  // as many as entries times channels
  int channels = 1;           // 1, or 3: red, green, blue
  bool linear = true;         // between centres; false: the nearest one
  int entries() const { return static_cast<int>(values.size()) / channels; }
  bool operator==(const VolumeTable&) const = default;
};

/// How samples are lit by a light at the viewer.
struct VolumeLight {
  bool enabled = false;
  bool twoSided = false;
  glm::vec3 ambient{0}, diffuse{0}, specular{0};  // material times light
  float shininess = 1;
};

/// The volume and its look. "Texture space" has the voxels in 0 .. 1; "data space" is that of the box's
/// vertices.
struct Volume {
  std::shared_ptr<const VoxelGrid> grid;
  bool linear = true;         // between voxels; false: the nearest one
  bool byteFilter = false;    // as Texture::byteFilter
  float scale = 1, bias = 0;  // from a texture's value to the scalar that tables are read with
  VolumeBlend blend = VolumeBlend::composite;
  VolumeTable opacity, color;                          // opacity of a step
  std::shared_ptr<const VolumeTable> gradientOpacity;  // by the gradient's length; null: none
  VolumeLight light;
  glm::vec3 cellStep{0};                // texture space: distances of the samples of gradients
  glm::vec3 cellSpacing{1};             // data space
  glm::vec2 range{0, 1};                // values of data for scalars 0 and 1
  glm::vec2 averaged{0, 1};             // values of data that VolumeBlend::average counts
  float least = 1 - 1.0f / 255;         // rays end above this opacity
  float colorScale = 1, colorBias = 0;  // of the finished colour
};

/// Where the rays of a volume begin and end.
struct VolumeView {
  Region region;                 // window pixels
  glm::dmat4 windowFromData{1};  // window coordinates x, y, z (0 .. 1) of data space, homogeneous
  glm::dmat4 textureFromData{1};
  glm::dvec3 viewer{0};           // data space
  glm::dvec3 direction{0};        // data space, of all rays; 0: they come from the viewer
  float step = 0;                 // length of a step in data space
  glm::vec3 lower{0}, upper{1};   // texture space: rays end where they leave this box
  std::vector<glm::dvec3> faces;  // data space: triangles, three corners each, on which rays begin
  std::vector<float>
      depth;  // of what ends rays, one for each pixel of the region, window depths; empty: nothing
  /// How far behind the entry the first sample lies, in steps, for each window pixel of a rectangle that
  /// repeats; empty: one step.
  std::vector<float> jitter;
  glm::ivec2 jitterSize{0};
  enum class DepthTest : uint8_t { none, less, lessOrEqual } depthTest = DepthTest::none;  // of the faces
  /// Of a multisampled framebuffer, in [0,1)^2 from the pixel's lower left corner; empty: pixels have one
  /// sample. A pixel's colour counts for the share of samples that the faces cover.
  std::vector<glm::vec2> samplePositions;
};

struct VolumeCast {
  Volume volume;
  VolumeView view;
  int threads = 0;
};

}  // namespace gluray::scene
