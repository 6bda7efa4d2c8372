// Which views of a framebuffer have been drawn since its colours were cleared: decides which of them get a
// ground. A part of ViewScenes, GL thread.
#pragma once
#include "gl/batch/batch.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::gl {

class ShownViews {
 public:
  /// Whether the batch may begin to show a ground: not in an inset, such as an orientation marker, which lies
  /// within a view that was drawn before it; and not in a further layer over a view that has one.
  bool mayStand(const BatchKey&, uint64_t frame) const;
  /// A batch was traced.
  void traced(const BatchKey&, const scene::Snapshot&);
  /// Colours of the framebuffer were cleared in `box`.
  void colorCleared(GLuint framebuffer, const scene::Region& box) noexcept;
  void clear() { views_.clear(); }
  bool empty() const { return views_.empty(); }

 private:
  struct View {
    GLuint framebuffer;
    GLenum drawBuffer;
    glm::ivec4 viewport;
    uint64_t frame;
    bool hasGround;
  };
  std::vector<View> views_;
};

/// Whether the batch shows a surface that the program lights. Pictures to pick from have none.
bool holdsLitSurface(const scene::Snapshot&);

}  // namespace gluray::gl
