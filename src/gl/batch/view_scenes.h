// What each view of a context holds beside the pending batch, so that surfaces of one view light each other
// although they are traced in several batches (adr/0047). Empty while no setting asks for light. A part of
// each Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "scene/surroundings.h"

#include <memory>
#include <vector>

namespace gluray::gl {

/// A view: one camera and viewport of one framebuffer, from one clear of its depth to the next (a depth
/// epoch).
class ViewScenes {
 public:
  /// What surrounds a batch that is about to be traced. Null where nothing does, where no setting asks for
  /// light, and where memory has run out.
  std::shared_ptr<const scene::Surroundings> around(const BatchKey&, const scene::Snapshot&) noexcept;
  /// The batch was traced, or surely will be: it belongs to its view.
  void traced(const BatchKey&, const scene::SnapshotPtr&) noexcept;
  /// Depth of the framebuffer was cleared in `box`: views whose surfaces all lie there begin anew.
  void depthCleared(GLuint framebuffer, const scene::Region& box);
  /// The same for the window, whose content is undefined after a swap.
  void swapped();
  void forget() { open_.clear(); }
  bool empty() const { return open_.empty(); }

 private:
  struct Epoch {
    GLuint framebuffer = 0;
    GLenum drawBuffer = 0;
    glm::ivec4 viewport{0};
    scene::Region drawn;                      // the regions of all batches lie in it
    std::vector<scene::SnapshotPtr> batches;  // in the order of drawing, never empty
  };
  bool holds(const Epoch&, const BatchKey&, const scene::Snapshot&) const;
  Epoch* epochOf(const BatchKey&, const scene::Snapshot&);

  std::vector<Epoch> open_;  // the newest one last
};

}  // namespace gluray::gl
