// Cache of the last traced images, for unchanged frames: programs redraw after expose events, or for a
// cursor or a screenshot. GL thread, one per context.
#pragma once
#include "base/image.h"
#include "frame/refinement/refinement.h"
#include "scene/secondary_scene.h"
#include "scene/snapshot.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::frame {

class ImageCache {
 public:
  /// Budget in bytes; beyond it, as for a 4K window, only the last image is kept.
  static constexpr size_t kBudget = size_t{96} << 20;

  struct CachedImage {
    Image image;
    uint64_t id = 0;  // unique; never 0 for a traced image
    // For images with light: their refinement, and whether it is complete.
    std::unique_ptr<Refinement> refinement;
    bool refined = false;
    bool moving = false;  // a frame of an animation: few rays, filtered
  };
  enum class Of : uint8_t {
    equalSnapshot,
    thisSnapshot,  // the snapshot with its number
  };
  /// The image of an equal earlier snapshot, with misses in `missColor` if given; null: none. Valid until
  /// makeRoom().
  CachedImage* findImage(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor = {},
                         Of which = Of::equalSnapshot) noexcept;
  /// Null if it was replaced.
  CachedImage* withId(uint64_t id) noexcept {
    for (Entry& entry : entries_)
      if (entry.cached.id == id) return &entry.cached;
    return nullptr;
  }
  /// Invalidates the image; its memory is reused for the next one.
  void drop(const CachedImage& cached) noexcept {
    for (Entry& entry : entries_)
      if (&entry.cached == &cached) entry.whole = false, entry.used = 0;
  }
  /// Gives an image a new id, because its pixels change.
  void renew(CachedImage& cached) noexcept { cached.id = ++ids_; }
  /// Frees the refinement of this view's images; 0: of all images.
  void forgetPasses(uint64_t view = 0) noexcept;
  /// Memory for a new image; replaces the least recently used one.
  CachedImage& makeRoom() noexcept;
  /// Marks the image from makeRoom() as finished and showing `snapshot`. Does not keep its meshes alive.
  void keep(const scene::Snapshot& snapshot) noexcept;
  size_t bytes() const noexcept;  // memory of all images, without passes

 private:
  struct Entry {
    CachedImage cached;
    uint64_t used = 0;
    bool whole = false;  // finished
    // Without meshes.
    scene::Snapshot shows;
    std::shared_ptr<scene::SecondaryScene> around;         // of `shows`; null: none
    std::vector<std::weak_ptr<const scene::Mesh>> meshes;  // of both
  };
  void keepWithinBudget() noexcept;
  static bool areSame(std::vector<scene::Instance>& kept, const std::weak_ptr<const scene::Mesh>* meshes,
                      const std::vector<scene::Instance>& now) noexcept;
  static bool isSame(Entry& entry, const scene::Snapshot& snapshot) noexcept;

  std::array<Entry, 3> entries_;
  Entry* next_ = nullptr;
  uint64_t uses_ = 0, ids_ = 0;
};

}  // namespace gluray::frame
