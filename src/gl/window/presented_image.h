// A traced image that the window already shows while its back buffer still lacks it (ADR 0024). A software
// OpenGL takes longer to accept an image with its depth and to swap it than the window system takes to show
// it, and most programs then clear it. If anything but a clear follows, the image is first written into the
// back buffer. The clear below is held back, too, because such frames hide it. Owned by WindowFrames, GL
// thread.
#pragma once
#include "gl/batch/held_batch.h"
#include "gl/batch/window_presenter.h"

#include <optional>

namespace gluray::gl {

struct PresentedImage {
  std::optional<HeldBatch> waiting;
  /// A clear of the whole back buffer that has not been made yet. `waiting` and the pending batch are drawn
  /// over it.
  std::optional<WindowClear> clear;
  ShownWindow* window = nullptr;  // the window that the last image was shown in
  /// Whether replacing `clear` by a clear of `mask` would lose the stencil clear.
  bool losesStencil(GLbitfield mask) const { return clear && clear->mask & ~mask & GL_STENCIL_BUFFER_BIT; }
  /// Reports that a clear hides the image.
  void hide() { waiting.reset(), clear.reset(), inVain = 0; }
  /// Number of consecutive images that had to be written after all: for programs that continue drawing,
  /// writing at once is faster.
  int inVain = 0;
  int pause = 0;  // frames to wait until the next attempt
};

}  // namespace gluray::gl
