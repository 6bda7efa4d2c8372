// Intersects primary rays with the ground, also in front of the near plane and behind the far plane, which
// programs fit to their own scene. For secondary rays the ground is an ordinary instance. Owned by World.
#pragma once
#include "accel/rays/ray_packet.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::accel {

class Ground {
 public:
  Ground() = default;
  /// None, unless one of the snapshot's own instances is the ground (Instance::ground).
  explicit Ground(const scene::Snapshot&);
  bool exists() const { return instance_ != kNoHit; }
  /// Extends a box in world space by the ground.
  void extend(glm::vec3& lower, glm::vec3& upper) const;
  /// Replaces the hits of valid lanes if the ground is nearer; a catcher replaces only misses. A ray with
  /// tNear = 0 starts at the viewer.
  void intersect(const int32_t* valid, RayPacket&) const noexcept;

 private:
  uint32_t instance_ = kNoHit;
  bool catches_ = false;
  double half_ = 1;  // of its sides, object space
  glm::dmat4 objectFromWorld_{1};
  glm::dvec4 viewer_{0};  // world space; w = 0: infinitely far away
};

}  // namespace gluray::accel
