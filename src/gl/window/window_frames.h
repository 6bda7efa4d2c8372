// Shows a window's frames without its back buffer (adr/0024), or later, while the program prepares the next
// one (adr/0023). A part of each Context, GL thread.
#pragma once
#include "gl/pending/pending_batch.h"
#include "gl/window/lagged_frame.h"
#include "gl/window/presented_image.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <optional>

namespace gluray::gl {

class LayerDraws;

class WindowFrames {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    PendingBatch& pending;
    LayerDraws& layers;
  };
  explicit WindowFrames(const Parts& parts) : p_(parts) {}

  // --- before a swap; FrameEnds calls the first and the last of these, after it has closed the open run
  /// Whether the swap would show only a clear and the pending batch.
  bool mayShowDirectly() noexcept;
  /// If mayShowDirectly(), replaces FrameEnds::beforeSwap() and the swap of a window of this size: traces the
  /// batch and passes the image to `show`. Returns false if nothing was shown; the batch then stays pending.
  /// `window` outlives this context.
  bool showWithoutSwap(ShownWindow& window, glm::ivec2 size, const ShowImage& show) noexcept;
  /// Whether the back buffer contains nothing of the next frame, because its clear and its draws are held
  /// back.
  bool holdsFrame() const { return presented_.clear && !presented_.waiting; }
  /// Replaces FrameEnds::beforeSwap() and the swap: starts tracing the batch, to show the frame later.
  /// Returns `none`, or why the frame cannot lag.
  LagRefusal lag(const LagWindow& window) noexcept;

  /// Call after a swap. If settings ask for light, remembers the frame's images, and refines them in the
  /// window while the program is idle. `open` may return null.
  void refineWhileIdle(const OpenIdleWindow& open) noexcept;

  /// Whether a lagged frame waits to be shown.
  bool lags() const { return lagged_.has_value(); }
  /// Shows the lagged frame. Call before the window's buffers are read or drawn into.
  void showLagged();
  /// Delays a clear until the lagged frame is shown, or holds it back while frames are shown directly.
  /// Returns false if the clear must be made now.
  bool clearsLater(GLbitfield mask);
  /// Whether the back buffer lacks a clear that was held back, or the image that the window shows.
  bool lacks() const { return presented_.waiting || presented_.clear; }
  /// Makes the held-back clear in the back buffer.
  void makeClear();
  /// Shows the lagged frame, makes the held-back clear and writes the shown image.
  void settle();
  /// settle(), if the draw framebuffer is the window.
  void settleInWindow();
  /// Call before the real OpenGL draws: shows the lagged frame, and calls settleInWindow().
  void meetDraw();
  /// Call before any draw, also one that will be traced: calls settleInWindow() if an image waits to be
  /// written.
  void settleBelow() {
    if (presented_.waiting) settleInWindow();
  }
  /// Call before the draw framebuffer is cleared: drops the shown image if the clear hides it, else calls
  /// settle().
  void clears(GLbitfield mask);
  /// Whether a draw kept for these frames reads a texture other than a buffer texture.
  bool readsImages() const;
  /// Whether such a draw reads `buffer` as a buffer texture.
  bool readsBuffer(GLuint buffer) const;

 private:
  LagRefusal whyNotLag(GLenum buffer) const;
  void noteBegin();
  /// Holds back a clear of the whole window if it hides everything that the back buffer lacks.
  bool holdsClear(GLbitfield mask);
  /// If the window's size has changed since, writes the image that the window shows, and makes the real
  /// OpenGL swap.
  void meetNewSize();
  bool showsDirectly(const LaggedFrame& frame);
  PresentResult presentLagged(LaggedFrame& frame);

  PresentedImage presented_;
  std::optional<LaggedFrame> lagged_;
  Parts p_;
};

}  // namespace gluray::gl
