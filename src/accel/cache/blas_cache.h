// Cache of BLASes, keyed by geometry content and quality. Owned by World; one thread at a time.
#pragma once
#include "accel/cache/build_plan.h"
#include "accel/meshes/blas.h"
#include "accel/meshes/deformation.h"
#include "base/background_job.h"

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

namespace gluray::accel {

class PageCache;

/// Builds each (geometry, quality) once and keeps it while it is used. Idle structures stay while they and
/// the arrays they keep alive fit into `idleBudgetBytes`. Beyond it, the least recently used are freed first.
/// Structures of the previous batch, and structures that were once freed too early, are freed last; they may
/// exceed the budget if the machine has as much free memory. With quality `automatic`, fast structures are
/// replaced by full ones, built in the background, where build_plan.h finds that worthwhile.
class BlasCache {
 public:
  /// `pages`: cache of meshes that are loaded on demand; must outlive all structures.
  BlasCache(const Device&, PageCache& pages, size_t idleBudgetBytes, FreeMemory);

  /// Begins a batch of the program's frame `frame`: structures that are not requested from now on are idle. A
  /// finished full structure replaces the fast structure of its mesh.
  void beginBatch(uint64_t frame);
  /// Returns the structures for `wanted`, in the same order (null where a mesh has no triangles). Builds
  /// missing ones with the threads of the current arena. Throws Error or std::bad_alloc; structures built by
  /// then stay in the cache. `thrifty`: new structures take as little memory as possible, whatever the
  /// quality.
  std::vector<BlasPtr> get(const std::vector<Geometry>& wanted, BvhQuality, bool thrifty = false);
  /// Like get(), for geometry that only secondary rays hit. Builds missing structures, but does not count as
  /// use for the decisions about later builds and refits.
  std::vector<BlasPtr> aside(const std::vector<Geometry>& wanted, BvhQuality);
  /// Whether `thrifty` would change any structure that is still missing.
  bool thriftHelps(const std::vector<Geometry>& wanted, BvhQuality) const;
  /// Frees idle structures beyond the budget.
  void evict();
  /// Frees the structures whose meshes no longer exist, because their contexts were destroyed, or whose
  /// Geometry did not name an owner.
  void evictOrphans();
  /// Frees every idle structure and cancels the background build; true if there were any.
  bool evictAllIdle();

  uint64_t builds() const { return builds_; }            // builds that a frame waited for, since the start
  uint64_t refits() const { return refits_; }            // of those, refits of earlier positions
  uint64_t refinements() const { return refinements_; }  // fast structures replaced by full ones
  bool refining() const { return refinement_.busy(); }   // a full structure is being built
  bool refined() const { return refinement_.done(); }    // a full structure waits for the next batch
  size_t size() const { return entries_.size(); }
  uint64_t frames() const { return frames_; }  // how often the number of the program's frame has changed

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
    BvhQuality built = BvhQuality::full;         // never automatic
    uint64_t lastUsed = 0, lastFrame = 0;        // clock_ and frames_ at the last use
    uint64_t batches = 0;                        // number of batches that used it
    bool returns = false;                        // it was freed and soon requested again
    bool needed = false;                         // set by evict(): expected to be used again soon
    std::weak_ptr<const scene::Mesh> mesh = {};  // for which it is used
  };
  bool evictDownTo(size_t bytes);
  BlasPtr use(Entry& entry, const Geometry& geometry);
  bool isRecent(const Entry& entry) const;
  Waiting waitingOf(const std::vector<Geometry>& wanted, BvhQuality) const;
  void build(std::vector<std::pair<Key, Entry>>& coming);
  using Entries = std::unordered_map<Key, Entry, KeyHash>;
  Entries::iterator formerOf(const scene::Mesh&, const std::vector<Geometry>& wanted, BvhQuality);
  /// The structure to build for a mesh that deforms; null: build it like any other.
  BlasPtr deformed(const Geometry&, const std::vector<Geometry>& wanted, BvhQuality);
  void refine(const Key& key, Entry& entry, const Geometry& geometry);

  BlasPtr made(const Geometry&, BvhQuality);

  const Device& device_;
  PageCache& pages_;
  size_t idleBudgetBytes_;
  FreeMemory freeMemory_;
  IotaIndices iota_;
  Entries entries_;
  uint64_t clock_ = 0;               // counts batches
  uint64_t frame_ = 0, frames_ = 0;  // the program's frame number, and how often it has changed
  uint64_t builds_ = 0, refits_ = 0, refinements_ = 0;
  Deformations deformations_;
  std::array<Hash128, 64>
      left_{};  // geometries whose structures were refitted to other positions most recently
  std::array<Hash128, 64> freed_{};  // geometries whose structures were freed soon after use most recently
  size_t freedCount_ = 0;
  Key refining_{};   // key of the structure that the background job builds
  BlasPtr refined_;  // that structure
  BackgroundJob refinement_;
};

}  // namespace gluray::accel
