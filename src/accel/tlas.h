// The instances of a frame over their meshes' structures. Owned by World; read by any number of tracing
// threads.
#pragma once
#include "accel/meshes/blas.h"

#include <glm/glm.hpp>

#include <vector>

struct RTCGeometryTy;

namespace gluray::accel {

/// A mesh structure placed in the world. `blas` null: nothing to hit.
struct PlacedBlas {
  BlasPtr blas;
  glm::mat4 worldFromObject{1};
  bool operator==(const PlacedBlas&) const = default;
};

/// The top-level structure; it keeps the meshes' structures alive.
class Tlas {
 public:
  explicit Tlas(const Device&);
  ~Tlas();
  Tlas(const Tlas&) = delete;
  Tlas& operator=(const Tlas&) = delete;

  /// Makes the structure hold `instances` and nothing else; hits bear indices into it. Does nothing if they
  /// are what it holds. True if it had to build. Throws Error; the next call then builds anew.
  bool update(std::vector<PlacedBlas> instances);
  /// What it holds; empty where that is not known.
  const std::vector<PlacedBlas>& held() const { return held_; }
  RTCSceneTy* scene() const { return scene_; }

 private:
  void place(size_t index, const PlacedBlas*);

  const Device& device_;
  RTCSceneTy* scene_ = nullptr;
  std::vector<PlacedBlas> held_;
  std::vector<RTCGeometryTy*> geometries_;  // null where nothing is to hit
};

}  // namespace gluray::accel
