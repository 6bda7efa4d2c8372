// Acceleration structures of meshes, found again by what the geometry is. Owned by World; one thread at a
// time.
#pragma once
#include "accel/meshes/blas.h"
#include "accel/meshes/build_plan.h"
#include "accel/meshes/deformation.h"
#include "base/background_job.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace gluray::accel {

/// Builds each (geometry, quality) once and keeps it while it is used. What was not used lately stays too,
/// as long as all such structures and the arrays they keep alive fit into `idleBudgetBytes`; beyond it the
/// longest unused go first, but those of the batch before, and those that were missed before, last: they may
/// stay while as much memory is free. Structures of quality `automatic` are exchanged for better ones, which
/// are built while frames go on, where build_plan.h finds that worth it.
class BlasCache {
 public:
  BlasCache(const Device&, size_t idleBudgetBytes, FreeMemory);

  /// Begins a batch of the program's frame of this number: what is not asked for from now on is idle. Better
  /// structures that are ready take the place of those they were built for.
  void beginBatch(uint64_t frame);
  /// Structures for `wanted` (null where a mesh has no triangles), in the same order, building those not yet
  /// known with the threads of the current arena. Throws Error or std::bad_alloc; those already built stay
  /// known. `thrifty`: what is built now takes as little memory as can be, whatever its quality was to be.
  std::vector<BlasPtr> get(const std::vector<Geometry>& wanted, BvhQuality, bool thrifty = false);
  /// Whether that makes a difference to any that are not known yet.
  bool thriftHelps(const std::vector<Geometry>& wanted, BvhQuality) const;
  /// Frees idle structures beyond the budget.
  void evict();
  /// Frees every idle structure and what is being built behind; true if there were any.
  bool evictAllIdle();

  uint64_t builds() const { return builds_; }            // that a frame waited for, since the start
  uint64_t refits() const { return refits_; }            // of those, adjusted ones of earlier positions
  uint64_t refinements() const { return refinements_; }  // better structures put in place, since the start
  bool refining() const { return refinement_.busy(); }   // one is being built
  bool refined() const { return refinement_.done(); }    // one waits for the next frame
  size_t size() const { return entries_.size(); }

 private:
  struct Key {
    Hash128 geometry;
    BvhQuality quality;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    size_t operator()(const Key& k) const noexcept {
      return std::hash<Hash128>{}(k.geometry) + static_cast<size_t>(k.quality);
    }
  };
  struct Entry {
    BlasPtr blas;
    BvhQuality built = BvhQuality::full;   // never automatic
    uint64_t lastUsed = 0, lastFrame = 0;  // clock_ and frames_ of that time
    uint64_t batches = 0;                  // in which it was used
    bool returns = false;                  // it was freed and asked for again soon
    bool needed = false;                   // evict(): it is idle for the moment, by all that is known
  };
  bool evictDownTo(size_t bytes);
  BlasPtr use(Entry& entry);
  bool isRecent(const Entry& entry) const;
  Waiting waitingOf(const std::vector<Geometry>& wanted, BvhQuality) const;
  void build(std::vector<std::pair<Key, Entry>>& coming);
  using Entries = std::unordered_map<Key, Entry, KeyHash>;
  Entries::iterator formerOf(const scene::Mesh&, const std::vector<Geometry>& wanted, BvhQuality);
  /// The structure to be built for a mesh that moves; null: it is to be built like any other.
  BlasPtr deformed(const Geometry&, const std::vector<Geometry>& wanted, BvhQuality);
  void refine(const Key& key, Entry& entry, const Geometry& geometry);

  const Device& device_;
  size_t idleBudgetBytes_;
  FreeMemory freeMemory_;
  IotaIndices iota_;
  Entries entries_;
  uint64_t clock_ = 0;               // batches
  uint64_t frame_ = 0, frames_ = 0;  // the program's number of this one, and how often it has changed
  uint64_t builds_ = 0, refits_ = 0, refinements_ = 0;
  Deformations deformations_;
  std::array<Hash128, 64> left_{};   // geometries whose structures were adjusted to others, the last ones
  std::array<Hash128, 64> freed_{};  // geometries whose structures went soon after their use, the last ones
  size_t freedCount_ = 0;
  Key refining_{};   // what the job builds for
  BlasPtr refined_;  // what it builds
  BackgroundJob refinement_;
};

}  // namespace gluray::accel
