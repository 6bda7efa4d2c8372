// One draw of a volume by a ray caster in a fragment shader, as plain data. Immutable.
#pragma once
#include "scene/region.h"
#include "scene/volumes/transfer_function.h"
#include "scene/volumes/volume_levels.h"
#include "scene/volumes/volume_shading.h"
#include "scene/volumes/voxel_grid.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::scene {

/// How the samples of a ray become one colour. `isosurface`: where the scalar crosses one of the contours
/// between two samples, its colour is composited. Those from `refinedMaximum` on take Volume::levels, and
/// show colours that are not premultiplied:
/// - refinedMaximum, refinedMinimum: of all samples up to the first one at the upper or lower limit, and of
/// ten
///   more around the one that is found;
/// - attenuatedMaximum: of samples times exp(-attenuation (sum - 1)), with the sum of what they count times
/// their
///   place between the limits;
/// - over: front to back, up to an opacity of 0.99; screened: 1 - product of (1 - colour) of all samples;
/// - mean: of all scalars;
/// - surface: lit by a light at the viewer where the scalar exceeds a threshold, at a tenth of a step.
enum class VolumeBlend : uint8_t {
  composite,
  maximum,
  minimum,
  average,
  additive,
  isosurface,
  refinedMaximum,
  refinedMinimum,
  attenuatedMaximum,
  over,
  screened,
  mean,
  surface
};
constexpr bool takesLevels(VolumeBlend blend) { return blend >= VolumeBlend::refinedMaximum; }

/// Which channels of a voxel a sample's colour and opacity are read with.
enum class VolumeChannels : uint8_t {
  one,              // both by channel 0
  independent,      // each channel has its own; they are mixed by weights
  colorAndOpacity,  // the colour by channel 0, the opacity by channel 1
  colors,           // channels 0 to 2 are the colour, the opacity is read by channel 3
  table,            // both by channel 0 and the length of its gradient, from Volume::table
  labels            // as `one`; samples with a label by channel 0 and the label, from Volume::table
};

/// The channel whose scalars the opacity of a sample is read with; of independent ones, each.
constexpr size_t opacityChannelOf(VolumeChannels use) {
  return use == VolumeChannels::colorAndOpacity ? 1 : use == VolumeChannels::colors ? 3 : 0;
}

/// Samples in some of 27 boxes are skipped: the planes cut each axis into three parts.
struct VolumeCropping {
  std::array<float, 6> planes{};  // texture space: two for each axis
  std::array<bool, 27> kept{};    // x fastest
  bool operator==(const VolumeCropping&) const = default;
};

/// Labels of samples: of VolumeChannels::labels.
struct VolumeLabels {
  std::shared_ptr<const VoxelGrid> voxels;  // bytes; the nearest one counts
  std::array<float, 256> rows{};            // of each byte: 0: no label; others: coordinate in Volume::table
  float share = 1;  // of a label's colour and opacity; the rest is that of a sample without a label
};

/// The volume and its look. "Texture space" has the voxels in 0 .. 1; "data space" is that of the box's
/// vertices.
struct Volume {
  std::shared_ptr<const VoxelGrid> grid;
  bool linear = true;       // between voxels; false: the nearest one
  bool byteFilter = false;  // as Texture::byteFilter
  VolumeBlend blend = VolumeBlend::composite;
  VolumeChannels use = VolumeChannels::one;
  std::vector<VolumeChannel> channels = std::vector<VolumeChannel>(1);  // as many as `use` has, at most 4
  VolumeLabels labels;
  std::shared_ptr<const VolumeTable2D> table;  // of VolumeChannels::table and ::labels
  size_t gradientChannel = 0;  // whose gradients count, with the look of channel 0; of independent ones, each
  VolumeShading shading;
  glm::vec3 cellStep{0};        // texture space: distances of the samples of gradients
  glm::vec3 cellSpacing{1};     // data space
  glm::vec2 averaged{0, 1};     // values of data that VolumeBlend::average counts
  VolumeLevels levels;          // of blends that take them; channel 0 has the map as `color`
  std::vector<float> contours;  // scalars, in ascending order, of VolumeBlend::isosurface
  std::shared_ptr<const VolumeCropping> cropping;  // null: none
  std::shared_ptr<const VoxelGrid> mask;           // samples where it is 0 or less are skipped; null: none
  bool maskLinear = false;                         // between its voxels; false: the nearest one
  float least = 1 - 1.0f / 255;                    // rays end above this opacity
  float colorScale = 1, colorBias = 0;             // of the finished colour
};

/// Planes beyond which rays do not go.
struct VolumeClipping {
  std::vector<glm::dvec4> planes;  // of a space: rays stay where dot(plane, (p, 1)) is not below 0
  glm::dmat4 spaceFromTexture{1};  // for the ends of rays
  glm::dmat3 spaceFromData{1};     // for their directions
};

/// A plane on which rays have their only sample.
struct VolumeSlice {
  glm::dvec4 plane{0};            // data space: where dot(plane, (p, 1)) is 0
  glm::dmat4 textureFromData{1};  // for the sample
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
  std::optional<VolumeClipping> clipping;
  std::optional<VolumeSlice> slice;
  std::optional<VolumeSpan> span;  // rays end on `faces` in place of beginning there
  std::vector<float>
      depth;  // of what ends rays, one for each pixel of the region, window depths; empty: nothing
  /// How far behind the entry the first sample lies, in steps, for each window pixel of a rectangle that
  /// repeats; empty: one step.
  std::vector<float> jitter;
  glm::ivec2 jitterSize{0};
  enum class DepthTest : uint8_t { none, less, lessOrEqual } depthTest = DepthTest::none;  // of the faces
  /// The framebuffer's colours are replaced, also where nothing is visible; otherwise it is blended over
  /// them.
  bool replaces = false;
  /// Of a multisampled framebuffer, in [0,1)^2 from the pixel's lower left corner; empty: pixels have one
  /// sample. A pixel's colour counts for the share of samples that the faces cover.
  std::vector<glm::vec2> samplePositions;
};

struct Snapshot;

struct VolumeCast {
  Volume volume;
  VolumeView view;
  int threads = 0;
  /// The view with this volume (Snapshot::volumes) and, in its secondary scene, all else; null: the settings
  /// change no light.
  std::shared_ptr<const Snapshot> lit;
};

}  // namespace gluray::scene
