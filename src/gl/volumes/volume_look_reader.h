// Reads the voxels, transfer functions and light of a volume that a shader program draws, as its family
// describes them. GL thread, context current.
#pragma once
#include "gl/families/family.h"
#include "gl/families/slot_fragments.h"
#include "gl/programs/uniforms.h"
#include "gl/shadow/shadow_state.h"
#include "scene/volumes/volume.h"

#include <memory>
#include <string>

namespace gluray::gl {

/// Use an object once.
class VolumeLookReader {
 public:
  /// `why`: gets the reason for the user where read() fails. Everything must outlive the object.
  VolumeLookReader(ShadowState& shadow, const UniformReader& uniforms, std::string& why);
  bool read(scene::Volume& volume);
  /// Reads the voxels, of which one channel counts, and how they are blended.
  bool readScalars(scene::Volume& volume);

 private:
  bool refuse(std::string why) { return why_ = std::move(why), false; }
  void readNumbers(scene::Volume& volume);
  bool readGrid(scene::Volume& volume);
  bool readMask(scene::Volume& volume);
  std::shared_ptr<const scene::VoxelGrid> readVoxels(const std::string& sampler, scene::Texture& sampling);
  /// The texture of a table: floats, without levels of detail, clamped to its edge along x.
  bool readTableTexture(const std::string& sampler, scene::Texture& texture);
  bool readTable(const std::string& sampler, int channels, scene::VolumeTable& table);
  bool readTable2D(const std::string& sampler, scene::Volume& volume);
  bool readLabels(scene::Volume& volume);
  bool readTables(scene::Volume& volume);
  bool readChannelTables(scene::Volume& volume, size_t channel, const std::string& index);
  bool readLight(scene::Volume& volume);
  bool readLights(scene::VolumeShading& shading);
  scene::VolumeLight lightAt(int number, bool positional) const;
  bool readCropping(scene::Volume& volume);
  bool readContours(scene::Volume& volume);
  glm::vec4 value(const FamilyValue& v, const glm::vec4& otherwise) const {
    return uniforms_.value(v, otherwise);
  }
  /// Of an array; a constant is that of all elements.
  glm::vec4 element(const FamilyValue& v, int number, const glm::vec4& otherwise) const;

  ShadowState& shadow_;
  const FamilyVolume& family_;
  const SlotWords& words_;
  const UniformReader& uniforms_;
  std::string& why_;
};

}  // namespace gluray::gl
