// The scene of secondary rays: the instances of a snapshot and of its secondary scene, over shared BLASes.
// Owned by World, updated between frames, read by any number of tracing threads.
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

  /// Replaces the contents by `drawn`, one for each instance of the snapshot, and `around`, one for each of
  /// its secondary scene. Omits instances for the kinds of rays that they are hidden from. Returns whether it
  /// built. Throws Error; the scene is then empty.
  bool update(const scene::Snapshot&, const std::vector<PlacedBlas>& drawn, std::vector<PlacedBlas> around,
              const HiddenFrom& hidden = {});
  /// For a snapshot without a secondary scene: secondary rays then use the scene of primary rays. Frees
  /// memory if later snapshots will have no secondary scene either.
  void clear(const scene::Snapshot&);
  /// Releases all contents. Returns whether there were any.
  bool release();

  /// Null: secondary rays use the scene of primary rays. Not for RayKind::camera.
  RTCSceneTy* scene(RayKind kind) const { return scenes_[indexOf(kind)]; }
  bool exists() const { return scenes_[0] != nullptr; }
  /// Bounds of all instances except the ground, in the space of SecondaryScene::viewFromWorld. Requires
  /// exists().
  const Bounds& bounds() const { return bounds_; }

 private:
  static constexpr size_t kKinds = 3;  // all but those of the viewer
  static constexpr size_t indexOf(RayKind kind) { return static_cast<size_t>(kind) - 1; }
  bool updateOne(const scene::Snapshot&, size_t kind, std::vector<PlacedBlas>);

  const Device& device_;
  std::array<std::optional<Tlas>, kKinds> tlas_;  // made at first use; kinds with equal instances share one
  std::array<RTCSceneTy*, kKinds> scenes_{};
  Bounds bounds_;
};

}  // namespace gluray::accel
