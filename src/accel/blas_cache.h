// Acceleration structures of meshes, found again by what the geometry is. Owned by World; one thread at a
// time.
#pragma once
#include "accel/blas.h"

#include <unordered_map>
#include <vector>

namespace gluray::accel {

/// Builds each (geometryId, quality) once and keeps it while it is used. What was not used lately stays too,
/// as long as all such structures and the arrays they keep alive fit into `idleBudgetBytes`; beyond it the
/// longest unused go first.
class BlasCache {
 public:
  BlasCache(const Device&, size_t idleBudgetBytes);

  /// Begins a frame: what is not asked for from now on is idle.
  void beginFrame() { ++clock_; }
  /// Structures for `meshes` (null where a mesh has no triangles), in the same order, building those not yet
  /// known with the threads of the current arena. Throws Error or std::bad_alloc; those already built stay
  /// known.
  std::vector<BlasPtr> get(const std::vector<const scene::Mesh*>& meshes, BvhQuality);
  /// Frees idle structures beyond the budget.
  void evict() { evictDownTo(idleBudgetBytes_); }
  /// Frees every idle structure; true if there were any.
  bool evictAllIdle() { return evictDownTo(0); }

  uint64_t builds() const { return builds_; }  // since the start
  size_t size() const { return blases_.size(); }

 private:
  struct Key {
    Hash128 geometryId;
    BvhQuality quality;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    size_t operator()(const Key& k) const noexcept {
      return std::hash<Hash128>{}(k.geometryId) + static_cast<size_t>(k.quality);
    }
  };
  bool evictDownTo(size_t bytes);

  const Device& device_;
  size_t idleBudgetBytes_;
  IotaIndices iota_;
  std::unordered_map<Key, BlasPtr, KeyHash> blases_;
  uint64_t clock_ = 0, builds_ = 0;
};

}  // namespace gluray::accel
