// What rays that leave surfaces meet: the instances of a snapshot and those of its surroundings, over the
// same BLASes. Owned by World, updated between frames, read by any number of tracing threads.
#pragma once
#include "accel/placement.h"
#include "accel/rays/ray_kind.h"
#include "accel/tlas.h"
#include "scene/snapshot.h"

#include <array>
#include <optional>
#include <vector>

namespace gluray::accel {

class LightScene {
 public:
  explicit LightScene(const Device& device) : device_(device) {}

  /// Replaces the contents: `drawn`, one for each instance of the snapshot, and `around`, one for each of its
  /// surroundings. Instances are left out for rays that they are hidden from. True if it built. Throws Error;
  /// it is empty then.
  bool update(const scene::Snapshot&, const std::vector<PlacedBlas>& drawn, std::vector<PlacedBlas> around,
              const HiddenFrom& hidden = {});
  /// The snapshot has no surroundings, so that light meets what the snapshot draws. Gives memory back where
  /// later ones will have none either.
  void clear(const scene::Snapshot&);
  /// Lets all contents go. True if there were any.
  bool release();

  /// Null: light meets what the viewer's rays meet. Not of RayKind::camera.
  RTCSceneTy* scene(RayKind kind) const { return scenes_[indexOf(kind)]; }
  bool exists() const { return scenes_[0] != nullptr; }
  /// Of all instances but the ground, in the space of Surroundings::viewFromWorld. Only where it exists().
  const Bounds& bounds() const { return bounds_; }

 private:
  static constexpr size_t kKinds = 3;  // all but those of the viewer
  static constexpr size_t indexOf(RayKind kind) { return static_cast<size_t>(kind) - 1; }
  bool updateOne(const scene::Snapshot&, size_t kind, std::vector<PlacedBlas>);

  const Device& device_;
  std::array<std::optional<Tlas>, kKinds> tlas_;  // made at first use; kinds that meet the same share one
  std::array<RTCSceneTy*, kKinds> scenes_{};
  Bounds bounds_;
};

}  // namespace gluray::accel
