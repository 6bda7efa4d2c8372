// One view during one depth epoch: its traced surfaces, and the corresponding epoch of an earlier frame. Kept
// by ViewScenes, GL thread.
#pragma once
#include "base/image.h"
#include "gl/batch/batch.h"
#include "scene/framebuffer_capture.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace gluray::gl {

struct ViewEpoch {
  struct Drawn {
    scene::SnapshotPtr snapshot;
    bool still = false;  // in eye space, since the frame before; false if unknown
    // Of surfaces that the real OpenGL has drawn; null: of others, or their colours are not known.
    std::shared_ptr<const scene::FramebufferCapture> capture;
    std::shared_ptr<const Image> written;  // PresentResult::written; null: it cannot be lit again
    std::vector<uint8_t> erased = {};      // by instance: not 0: a clear has removed it; empty: none
    /// Takes the snapshot of relitOf(), which lacks erased surfaces.
    void relight(scene::SnapshotPtr now) {
      if (now->instances.size() != snapshot->instances.size()) erased.clear();
      snapshot = std::move(now);
    }
  };
  GLuint framebuffer = 0;
  GLenum drawBuffer = 0;
  glm::ivec4 viewport{0};
  scene::Region region;        // the regions of all batches lie in it
  std::vector<Drawn> batches;  // in the order of drawing, not empty
  bool moves = false;          // what was drawn first has moved in eye space since the frame before
  uint64_t ended = 0;          // when
  std::shared_ptr<const ViewEpoch> last;  // null: nothing is known
  size_t repeated = 0;                    // number of its batches that are drawn again by now
  bool isChecked = false;                 // no batch was added since ViewScenes::outdated()

  bool holdsVolumes() const {
    return std::any_of(batches.begin(), batches.end(),
                       [](const Drawn& drawn) { return !drawn.snapshot->volumes.empty(); });
  }
  /// Drawn::written of the batches after number `i`, where they have it.
  std::vector<std::shared_ptr<const Image>> writtenAfter(size_t i) const {
    std::vector<std::shared_ptr<const Image>> found;
    while (++i < batches.size())
      if (batches[i].written) found.push_back(batches[i].written);
    return found;
  }
  const scene::Snapshot& first() const { return *batches.front().snapshot; }
};

/// Where a batch stands in the frame that is drawn again.
struct Repetition {
  size_t repeated = 0;                   // number of `last`'s batches that are drawn again with this one
  const ViewEpoch::Drawn* of = nullptr;  // the one that this batch repeats; null: none
};
Repetition repetitionOf(const ViewEpoch& last, size_t repeated, const scene::Snapshot&);

/// Whether a view that begins with this batch is likely to repeat the epoch.
enum class Likeness : uint8_t { none, resembles, same };
Likeness likenessOf(const scene::Snapshot& earlier, const scene::Snapshot& now);

/// How what most surfaces show has moved in eye space between two frames, by the surfaces of these batches,
/// of which each repeats the other.
class Movement {
 public:
  void compare(const scene::Snapshot& before, const scene::Snapshot& now);
  /// One surface was at `from`, and is at `to`: eyeFromObject.
  void compare(const glm::dmat4& from, const glm::dmat4& to) {
    if (moved_.size() < kMax) moved_.push_back(from == to ? glm::dmat4(1) : to * glm::inverse(from));
  }
  /// The movement that most surfaces share; none where nothing could be compared.
  std::optional<glm::dmat4> shared() const;

 private:
  static constexpr size_t kMax = 16;  // surfaces are enough
  std::vector<glm::dmat4> moved_;
};

/// Whether two places are equal but for the rounding of products of matrices.
bool areNear(const glm::dmat4& a, const glm::dmat4& b);

/// Whether all surfaces have equal places in eye space.
bool isStill(const scene::Snapshot& before, const scene::Snapshot& now);

}  // namespace gluray::gl
