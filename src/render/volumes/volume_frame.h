// All that the kernels need to cast the rays of a volume. Any thread.
#pragma once
#include "base/image.h"
#include "render/media/sample_illumination.h"
#include "render/volumes/volume_rays.h"
#include "scene/volumes/volume.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::render {

/// A transfer function for the kernels: entries of four numbers, the last one twice.
struct VolumeLookup {
  std::vector<glm::vec4> entries;
  float count = 0;  // entries without the repeated one
  bool linear = true;
};

struct ChannelLookups {
  VolumeLookup color;         // red, green, blue and, if opacity has as many entries, opacity
  VolumeLookup opacity;       // in its fourth number; no entries: color has it
  VolumeLookup gradient;      // likewise; no entries: none
  float scale = 1, bias = 0;  // from a stored number to the scalar
};

/// A transfer function of two coordinates: rows of entries, the last entry of each and the last row twice.
struct VolumeLookup2D {
  std::vector<glm::vec4> entries;
  glm::ivec2 size{0};  // without the repeated ones
  bool linear = true;
};

struct VolumeFrame {
  const scene::Volume* volume = nullptr;
  const VolumeRays* rays = nullptr;
  std::vector<ChannelLookups> channels;  // as Volume::channels
  VolumeLookup2D table;                  // Volume::table
  /// emptySpace(), and kEmptyPadding bytes that may be read; null: rays do not leap.
  const std::vector<uint8_t>* empty = nullptr;
  static constexpr size_t kEmptyPadding = 3;
  glm::ivec3 cells{0};
  Image* image = nullptr;
  const SampleIllumination* arriving = nullptr;  // null: samples have the light of the volume's shading
  bool showsInvisible = false;                   // pixels of rays that meet nothing are hits, too
};

/// Sets the transfer functions of the frame's volume: `channels` and `table`.
void addLookups(VolumeFrame& frame);

}  // namespace gluray::render
