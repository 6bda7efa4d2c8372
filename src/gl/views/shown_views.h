// Tracks, for each framebuffer, the views drawn since the last colour clear, and the clear colour. Decides
// which views get a ground and a background. A part of ViewScenes, GL thread.
#pragma once
#include "gl/batch/batch.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

class ShownViews {
 public:
  /// Whether the batch may begin to show a ground: not in an inset, such as an orientation marker, which lies
  /// within a view that was drawn before it; and not in a further layer over a view that has one.
  bool mayStand(const BatchKey&, uint64_t frame) const;
  /// Whether the batch belongs to a small view inside another one that was drawn before it, such as an
  /// orientation marker: at most a quarter of its area.
  bool isInset(const BatchKey&, uint64_t frame) const;
  struct Clear {
    GLuint framebuffer;
    scene::Region box;
    glm::vec4 color;
    uint64_t drawsBefore;  // draws that the real OpenGL had made
  };
  /// The last clear of all of the batch's region, if the batch may show a background there: if no view that
  /// holds it has shown one since. Of insets and layers, as above.
  std::optional<Clear> mayPaint(const BatchKey&, const scene::Region&, uint64_t frame) const;
  /// A batch was traced.
  void traced(const BatchKey&, const scene::Snapshot&);
  /// Colours of the framebuffer were cleared. Throws std::bad_alloc.
  void colorCleared(const Clear&);
  void clear() { views_.clear(), clears_.clear(); }
  bool empty() const { return views_.empty() && clears_.empty(); }

 private:
  struct View {
    GLuint framebuffer;
    GLenum drawBuffer;
    glm::ivec4 viewport;
    uint64_t frame;
    bool hasGround, hasBackdrop;
  };
  std::vector<View> views_;
  std::vector<Clear> clears_;  // the newest one last; none that a later one covers
};

/// Whether settings ask what is shown.
bool wantsShownViews(const Settings&);

/// Whether the batch shows a surface that the program lights. Images to pick from have none.
bool holdsLitSurface(const scene::Snapshot&);

}  // namespace gluray::gl
