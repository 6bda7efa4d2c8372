// Counts the frames of views by clears of their colours, for contexts that never swap. Ranks of an MPI
// program that draw a view in each frame have equal counts, independent of other clears. A part of
// ViewScenes, GL thread.
#pragma once
#include "gl/batch/batch.h"

#include <cstdint>
#include <vector>

namespace gluray::gl {

class ViewFrames {
 public:
  /// Colours of the framebuffer were cleared in `box`.
  void cleared(GLuint framebuffer, const scene::Region& box) noexcept;
  /// Something is traced in the region: the frame that it belongs to, from 1. Throws std::bad_alloc.
  uint64_t traced(GLuint framebuffer, const scene::Region& region);

 private:
  struct View {
    GLuint framebuffer;
    scene::Region region;
    uint64_t frame;
    bool isClear;
  };
  std::vector<View> views_;  // the one that was traced last is the last one
};

}  // namespace gluray::gl
