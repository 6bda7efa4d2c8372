// A traced image that the window shows already while its back buffer still lacks it (ADR 0024). A
// software OpenGL takes longer to accept an image with its depth and to swap it than the window system takes
// to show it, and most programs then clear it. If anything but a clear follows, the image is written into
// the back buffer first. The clear itself is held back, too, because such frames hide it. Owned by
// WindowFrames, GL thread.
#pragma once
#include "gl/batch/held_batch.h"
#include "gl/batch/window_presenter.h"

#include <optional>

namespace gluray::gl {

struct PresentedImage {
  std::optional<HeldBatch> waiting;
  /// A clear of the whole back buffer that is not made yet; `waiting` and the pending batch lie over it.
  std::optional<WindowClear> clear;
  ShownWindow* window = nullptr;  // that the last image was shown in
  /// Whether a clear of `mask` in place of `clear` would not clear the stencil that it clears.
  bool losesStencil(GLbitfield mask) const { return clear && clear->mask & ~mask & GL_STENCIL_BUFFER_BIT; }
  /// A clear hides it.
  void hide() { waiting.reset(), clear.reset(), inVain = 0; }
  /// Consecutive images that had to be written after all; programs that go on drawing are faster without.
  int inVain = 0;
  int pause = 0;  // frames to wait until the next attempt
};

}  // namespace gluray::gl
