// The top-level structure (TLAS): the instances of a frame over the BLASes of their meshes. Owned by World;
// read by any number of tracing threads.
#pragma once
#include "accel/meshes/blas.h"

#include <glm/glm.hpp>

#include <vector>

struct RTCGeometryTy;

namespace gluray::accel {

/// A BLAS placed in the world. `blas` null: nothing to hit.
struct PlacedBlas {
  BlasPtr blas;
  glm::mat4 worldFromObject{1};
  bool operator==(const PlacedBlas&) const = default;
};

/// Keeps the BLASes of its instances alive.
class Tlas {
 public:
  explicit Tlas(const Device&);
  ~Tlas();
  Tlas(const Tlas&) = delete;
  Tlas& operator=(const Tlas&) = delete;

  /// Replaces the contents by `instances`; hits report indices into it. Does nothing if the contents are
  /// equal. Returns whether it built. Throws Error; the next call then rebuilds from scratch. `eyeFromWorld`:
  /// camera of the instances' snapshot.
  bool update(std::vector<PlacedBlas> instances, const glm::dmat4& eyeFromWorld);
  /// Releases all instances. Returns whether there were any.
  bool clear();
  /// The current contents; empty if unknown (after an error).
  const std::vector<PlacedBlas>& held() const { return held_; }
  /// Camera of the update that set the contents.
  const glm::dmat4& heldFrom() const { return heldFrom_; }
  RTCSceneTy* scene() const { return scene_; }

 private:
  void placeInstance(size_t index, const PlacedBlas*);
  void release();

  const Device& device_;
  RTCSceneTy* scene_ = nullptr;
  std::vector<PlacedBlas> held_;
  glm::dmat4 heldFrom_{1};
  std::vector<RTCGeometryTy*> geometries_;  // null: nothing to hit
};

}  // namespace gluray::accel
