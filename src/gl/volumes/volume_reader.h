// Reads what a shader program that casts rays through a volume draws, as its family describes it. GL thread,
// context current.
#pragma once
#include "gl/program_state/program_state.h"
#include "gl/shadow/shadow_state.h"
#include "gl/volumes/volume_maps.h"
#include "scene/volumes/volume.h"

#include <string>

namespace gluray::gl {

/// Use an object once.
class VolumeReader {
 public:
  VolumeReader(ShadowState& shadow, VolumeMaps& maps);
  /// Reads all but faces, region and depths into `cast`. False, with the reason for the user in `why`.
  bool read(scene::VolumeCast& cast);
  /// Reads the depths of `region`, which must be set.
  bool readDepths(scene::VolumeView& view);
  const std::string& why() const { return why_; }
  /// From data space to clip coordinates with depths from -1 to 1.
  const glm::dmat4& clipFromData() const { return clipFromData_; }
  /// The identity where the program has no eye space of its own.
  glm::dmat4 eyeFromData() const {
    const auto known = uniforms_.product(program_.known->family->eyeFromObject);
    return known.value_or(glm::dmat4(1));
  }

 private:
  bool refuse(std::string why) { return why_ = std::move(why), false; }
  bool readViewer(scene::VolumeView& view);
  /// Of programs whose rays end on the faces: volume_span_reader.cpp.
  bool readSpanned(scene::VolumeCast& cast);
  bool readSpan(scene::VolumeSpan& span);
  bool readLevels(scene::Volume& volume);
  bool readLimits(scene::VolumeLevels& levels);
  bool readPlanes(scene::VolumeLevels& levels);
  bool readView(scene::VolumeView& view);
  bool readJitter(scene::VolumeView& view);
  bool readClipPlanes(scene::VolumeView& view);
  bool readSlice(scene::VolumeView& view);
  glm::vec4 value(const FamilyValue& v, const glm::vec4& otherwise) const {
    return uniforms_.value(v, otherwise);
  }

  ShadowState& shadow_;
  const ProgramState& program_;
  const FamilyVolume& family_;
  const UniformReader uniforms_;
  VolumeMaps& maps_;
  glm::dmat4 clipFromData_{1};
  std::string why_;
};

}  // namespace gluray::gl
