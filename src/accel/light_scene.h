// What rays that leave surfaces meet: the instances of a snapshot and those of its surroundings, over the
// same BLASes. Owned by World, updated between frames, read by any number of tracing threads.
#pragma once
#include "accel/placement.h"
#include "accel/tlas.h"
#include "scene/snapshot.h"

#include <optional>
#include <vector>

namespace gluray::accel {

class LightScene {
 public:
  explicit LightScene(const Device& device) : device_(device) {}

  /// Replaces the contents: `drawn`, one for each instance of the snapshot, and `around`, one for each of its
  /// surroundings. True if it built. Throws Error; it is empty then.
  bool update(const scene::Snapshot&, const std::vector<PlacedBlas>& drawn, std::vector<PlacedBlas> around);
  /// The snapshot has no surroundings, so that light meets what the snapshot draws. Gives memory back where
  /// later ones will have none either.
  void clear(const scene::Snapshot&);

  /// Null: there are no surroundings.
  RTCSceneTy* scene() const { return scene_; }
  /// Of all instances, in the space of Surroundings::viewFromWorld. Only with surroundings.
  const Bounds& bounds() const { return bounds_; }

 private:
  const Device& device_;
  std::optional<Tlas> tlas_;  // made at first use
  RTCSceneTy* scene_ = nullptr;
  Bounds bounds_;
};

}  // namespace gluray::accel
