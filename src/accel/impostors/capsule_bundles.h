// Capsule bundles of a mesh: up to eight neighbouring capsules as one primitive of the BVH. A vector test
// leaves few of them to the exact one (docs/adr/0116). Made by Blas; read by any number of tracing threads.
#pragma once
#include "accel/device/device.h"
#include "accel/impostors/impostor_reach.h"
#include "accel/impostors/placed_impostors.h"

#include <cstddef>
#include <cstdint>
#include <vector>

struct RTCBoundsFunctionArguments;

namespace gluray::accel {

/// Object space. Unused slots repeat the first capsule.
struct alignas(64) CapsuleBundle {
  static constexpr int kMost = 8;
  float middle[3][kMost];
  float half[3][kMost];  // from the middle to the second end
  uint32_t primitive[kMost];
  uint32_t count = 0;
};

class CapsuleBundles {
 public:
  /// Reads all capsules of a mesh, with the threads of the current arena; leaves out those that do not exist.
  /// `fast`: groups them along a Morton curve, otherwise by surface area. Throws Error or std::bad_alloc.
  CapsuleBundles(const Device&, const scene::Mesh&, const ImpostorReach&, bool fast);

  uint32_t count() const { return static_cast<uint32_t>(bundles_.size()); }
  const CapsuleBundle& operator[](uint32_t i) const { return bundles_[i]; }
  size_t bytes() const { return bundles_.size() * sizeof(CapsuleBundle); }
  /// The bounding box of a bundle's capsules.
  Box boxOf(uint32_t bundle) const;
  /// Whether a mesh has enough capsules for bundles to pay.
  static bool pay(const scene::Mesh& mesh) {
    return mesh.shape == scene::Shape::capsules && mesh.triangleCount >= 4 * CapsuleBundle::kMost;
  }

 private:
  const scene::Mesh& mesh_;  // outlives the bundles
  ImpostorReach reach_;
  std::vector<CapsuleBundle> bundles_;
};

/// Sets for each capsule of a bundle which of `lanes` may meet it: bit i for lane i. All that meet it are
/// among them. `rays`: rows of `count` <= 16 values, in the order of Embree's RTCRayN: origin x y z, tNear,
/// direction x y z, time, tFar; object space.
void nearCapsules(const CapsuleBundle&, const PlacedImpostors&, const float* rays, unsigned count,
                  uint32_t lanes, uint32_t (&near)[CapsuleBundle::kMost]);

}  // namespace gluray::accel
