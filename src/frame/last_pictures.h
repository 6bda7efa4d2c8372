// The last pictures that were traced, for frames in which nothing changes: programs draw again for an
// expose event, a cursor, a screenshot. GL thread, one per context.
#pragma once
#include "base/image.h"
#include "scene/snapshot.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::frame {

class LastPictures {
 public:
  /// Bytes of pictures beyond which only the last is held: of a window of 4K, for instance.
  static constexpr size_t kBudget = size_t{96} << 20;

  struct Picture {
    Image image;
    uint64_t id = 0;  // never 0 for a whole picture, and never the same for two
  };
  /// The picture of an earlier snapshot that shows the same, its misses in `missColor` where one is given;
  /// null: there is none. Valid until next().
  const Picture* of(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor = {}) noexcept;
  /// Memory for another picture, in the place of the one that was asked for longest ago.
  Picture& next() noexcept;
  /// What next() gave holds the picture of `snapshot` now. Its meshes are not kept alive.
  void keep(const scene::Snapshot& snapshot) noexcept;
  size_t bytes() const noexcept;  // of all pictures

 private:
  struct Entry {
    Picture picture;
    uint64_t used = 0;
    bool whole = false;
    scene::Snapshot shows;  // without meshes
    std::vector<std::weak_ptr<const scene::Mesh>> meshes;
  };
  void keepWithinBudget() noexcept;
  static bool isSame(Entry& entry, const scene::Snapshot& snapshot) noexcept;

  std::array<Entry, 3> entries_;
  Entry* next_ = nullptr;
  uint64_t uses_ = 0, ids_ = 0;
};

}  // namespace gluray::frame
