// What surfaces block of rays: clip planes cut all rays, and translucent surfaces block as much as their
// alpha. Made once a frame, asked on all tracing threads.
#pragma once
#include "accel/rays/occlusion.h"
#include "render/local/surface.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::render {

/// The occluders of a snapshot and its surroundings, which must outlive it, as must their surfaces. Both
/// sides of surfaces block, culled or not: what a program does not draw because it faces away still belongs
/// to a solid. Textures do not count: a surface is as opaque as its material and vertices say.
class Occluders {
 public:
  Occluders(const scene::Snapshot&, const std::vector<Surface>&);
  /// Whether every surface blocks every ray that meets it.
  bool areSolid() const { return planes_.empty() && !translucent_; }
  /// Whether some surface may let a part of a ray pass.
  bool areTranslucent() const { return translucent_; }
  /// Whether no clip plane of its instance cuts the point away.
  bool isThere(const accel::Occluder&) const;
  /// 1: nothing passes.
  float opacityOf(const accel::Occluder& o) const { return surfaceAt(o).a; }
  /// What passes of light: as much as the surface is not opaque, and tinted by its colour the more the
  /// opaquer it is. Grey surfaces do not tint.
  glm::vec3 transmittanceOf(const accel::Occluder&) const;

 private:
  /// Its colour without light, and its opacity, 0 .. 1.
  glm::vec4 surfaceAt(const accel::Occluder&) const;

  const std::vector<Surface>& surfaces_;
  const scene::Snapshot& snapshot_;
  bool translucent_;                             // the program blends some: alphas count
  std::vector<std::vector<glm::dvec4>> planes_;  // object space, by instance; empty where there are none
};

/// What of each ray of one packet passes all that it meets.
class Transmittance final : public accel::OccluderFilter {
 public:
  explicit Transmittance(const Occluders& occluders) : occluders_(occluders) {
    for (float& t : through) t = 1;
  }
  bool blocks(const accel::Occluder&) const noexcept override;

  mutable float through[accel::kLanes];  // of rays that nothing blocks

 private:
  const Occluders& occluders_;
};

/// The same in three channels.
class ColoredTransmittance final : public accel::OccluderFilter {
 public:
  /// `ignored`: instances that block nothing, sorted.
  ColoredTransmittance(const Occluders& occluders, const std::vector<uint32_t>& ignored)
      : occluders_(occluders), ignored_(ignored) {
    for (glm::vec3& t : through) t = glm::vec3(1);
  }
  bool blocks(const accel::Occluder&) const noexcept override;

  mutable glm::vec3 through[accel::kLanes];  // of rays that nothing blocks

 private:
  const Occluders& occluders_;
  const std::vector<uint32_t>& ignored_;
};

}  // namespace gluray::render
