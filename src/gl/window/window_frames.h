// Shows a window's frames without its back buffer (presented_frames.cpp), or later, while the program
// prepares the next one (lagged_frame.cpp). A part of each Context, GL thread.
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
  /// If mayShowDirectly(), in place of FrameEnds::beforeSwap() and the swap of a window of this size: traces
  /// the batch and gives the image to `show`. False: nothing was shown; the batch stays pending. `window`
  /// outlives this context.
  bool showWithoutSwap(ShownWindow& window, glm::ivec2 size, const ShowImage& show) noexcept;
  /// Whether nothing of the next frame is in the back buffer: its clear is held back, and so are its draws.
  bool holdsFrame() const { return presented_.clear && !presented_.waiting; }
  /// In place of both: starts tracing the batch, to show the frame later. Returns `none` or why not.
  LagRefusal lag(const LagWindow& window) noexcept;

  /// Call after a swap: if light is on, remembers the frame's images, and refines them in the window while
  /// the program draws nothing. `open` may return null.
  void refineWhileIdle(const OpenIdleWindow& open) noexcept;

  /// Whether a lagged frame waits to be shown.
  bool lags() const { return lagged_.has_value(); }
  /// Shows the lagged frame. Call before the window's buffers are read or drawn into.
  void showLagged();
  /// Delays a clear until the lagged frame is shown, or holds it back while frames are shown directly. False:
  /// clear now.
  bool clearsLater(GLbitfield mask);
  /// Whether the back buffer lacks a clear, or the image that the window shows.
  bool lacks() const { return presented_.waiting || presented_.clear; }
  /// Makes that clear in the back buffer.
  void makeClear();
  /// The same, and writes that image: always, or only if the draw framebuffer is the window.
  void settle();
  void settleInWindow();
  /// Call before the real OpenGL draws: shows the lagged frame, and settles in the window.
  void meetDraw();
  /// Call before a draw that will be traced, too: settleInWindow() if there is an image.
  void settleBelow() {
    if (presented_.waiting) settleInWindow();
  }
  /// Call before the draw framebuffer is cleared: drops the image if the clear hides it, else settles it.
  void clears(GLbitfield mask);
  /// Whether a draw kept for these frames reads a texture; whether one reads `buffer` as a texture.
  bool readsImages() const;
  bool readsBuffer(GLuint buffer) const;

 private:
  LagRefusal whyNotLag(GLenum buffer) const;
  void noteBegin();
  /// Holds a clear of the whole window back if it hides what the back buffer lacks.
  bool holdsClear(GLbitfield mask);
  /// Writes the image that the window shows, and makes the real OpenGL swap, if the window has changed its
  /// size since.
  void meetNewSize();
  bool showsDirectly(const LaggedFrame& frame);
  PresentResult presentLagged(LaggedFrame& frame);

  PresentedImage presented_;
  std::optional<LaggedFrame> lagged_;
  Parts p_;
};

}  // namespace gluray::gl
