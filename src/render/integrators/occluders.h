// Opacity of surfaces for shadow and occlusion rays: clip planes and the alpha test cut holes for all rays,
// and translucent surfaces block in proportion to their alpha. Made once a frame, called on all tracing
// threads.
#pragma once
#include "accel/rays/occlusion.h"
#include "render/local/surface.h"
#include "scene/snapshot.h"

#include <algorithm>
#include <vector>

namespace gluray::render {

/// The occluders of a snapshot and its secondary scene, which must outlive it, as must their surfaces. Both
/// sides of surfaces block, even if the program culls one: back faces still belong to a solid. The opacity is
/// that of material and vertices, and, of fixed function, of textures.
class Occluders {
 public:
  Occluders(const scene::Snapshot&, const std::vector<Surface>&);
  /// Whether every surface blocks every ray that hits it.
  bool areSolid() const { return planes_.empty() && !tested_ && !translucent_; }
  /// Whether some surface may be translucent.
  bool areTranslucent() const { return translucent_; }
  /// Whether the answers depend on Occluder::point.
  bool usePoints() const { return !planes_.empty(); }
  /// Whether the clip planes and the alpha test of the instance keep the point.
  bool isThere(const accel::Occluder&) const;
  /// Whether the alpha test of an instance keeps a point of that alpha.
  bool keeps(uint32_t instance, float alpha) const;
  /// Opacity at the point: 0 .. 1.
  float opacityOf(const accel::Occluder& o) const { return surfaceAt(o).a; }
  /// Transmittance of the surface: 1 - opacity, tinted by the surface's colour in proportion to the opacity.
  /// Grey surfaces do not tint.
  glm::vec3 transmittanceOf(const accel::Occluder&) const;

 private:
  glm::vec4 colorAt(const Surface&, const accel::Occluder&) const;
  /// Its colour without light, and its opacity, 0 .. 1.
  glm::vec4 surfaceAt(const accel::Occluder&) const;

  const std::vector<Surface>& surfaces_;
  const scene::Snapshot& snapshot_;
  bool translucent_;                             // the program blends some surfaces, so alpha counts
  bool tested_;                                  // some surfaces have an alpha test
  std::vector<std::vector<glm::dvec4>> planes_;  // object space, by instance; empty without clip planes
};

/// Accumulates the transmittance of each ray of a packet.
class Transmittance final : public accel::OccluderFilter {
 public:
  explicit Transmittance(const Occluders& occluders) : occluders_(occluders) {
    for (float& t : through) t = 1;
  }
  bool blocks(const accel::Occluder&) const noexcept override;
  bool usesPoints() const noexcept override { return occluders_.usePoints(); }

  mutable float through[accel::kLanes];  // of rays that are not blocked

 private:
  const Occluders& occluders_;
};

/// Accumulates the transmittance in three channels.
class ColoredTransmittance final : public accel::OccluderFilter {
 public:
  static constexpr uint32_t kNone = ~0u;

  /// `ignored`: instances that block nothing, sorted.
  ColoredTransmittance(const Occluders& occluders, const std::vector<uint32_t>& ignored)
      : occluders_(occluders), ignored_(ignored) {
    for (glm::vec3& t : through) t = glm::vec3(1);
    std::fill_n(ignoredByLane, accel::kLanes, kNone);
  }
  bool blocks(const accel::Occluder&) const noexcept override;
  bool usesPoints() const noexcept override { return occluders_.usePoints(); }

  mutable glm::vec3 through[accel::kLanes];  // of rays that are not blocked
  uint32_t ignoredByLane[accel::kLanes];     // an instance that does not block the lane's ray, or kNone

 private:
  const Occluders& occluders_;
  const std::vector<uint32_t>& ignored_;
};

}  // namespace gluray::render
