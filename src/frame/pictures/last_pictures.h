// Cache of the last traced pictures, for unchanged frames: programs redraw after expose events, or for a
// cursor or a screenshot. GL thread, one per context.
#pragma once
#include "base/image.h"
#include "frame/refinement/refinement.h"
#include "scene/snapshot.h"
#include "scene/surroundings.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::frame {

class LastPictures {
 public:
  /// Budget in bytes; beyond it, as for a 4K window, only the last picture is kept.
  static constexpr size_t kBudget = size_t{96} << 20;

  struct Picture {
    Image image;
    uint64_t id = 0;  // unique; never 0 for a traced picture
    // For pictures with light: their refinement, and whether it is complete.
    std::unique_ptr<Refinement> refinement;
    bool refined = false;
    bool moving = false;  // a frame of an animation: few rays, filtered
  };
  enum class Of : uint8_t {
    equalSnapshot,
    thisSnapshot,  // the snapshot with its number
  };
  /// The picture of an equal earlier snapshot, with misses in `missColor` if given; null: none. Valid until
  /// makeRoom().
  Picture* findPicture(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor = {},
                       Of which = Of::equalSnapshot) noexcept;
  /// Null if it was replaced.
  Picture* withId(uint64_t id) noexcept {
    for (Entry& entry : entries_)
      if (entry.picture.id == id) return &entry.picture;
    return nullptr;
  }
  /// Invalidates the picture; its memory is reused for the next one.
  void drop(const Picture& picture) noexcept {
    for (Entry& entry : entries_)
      if (&entry.picture == &picture) entry.whole = false, entry.used = 0;
  }
  /// Gives a picture a new id, because its pixels change.
  void renew(Picture& picture) noexcept { picture.id = ++ids_; }
  /// Frees the refinement of this view's pictures; 0: of all pictures.
  void forgetPasses(uint64_t view = 0) noexcept;
  /// Memory for a new picture; replaces the least recently used one.
  Picture& makeRoom() noexcept;
  /// Marks the picture from makeRoom() as finished and showing `snapshot`. Does not keep its meshes alive.
  void keep(const scene::Snapshot& snapshot) noexcept;
  size_t bytes() const noexcept;  // memory of all pictures, without passes

 private:
  struct Entry {
    Picture picture;
    uint64_t used = 0;
    bool whole = false;  // finished
    // Without meshes.
    scene::Snapshot shows;
    std::shared_ptr<scene::Surroundings> around;           // of `shows`; null: none
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
