// Frames of a window that are shown in other ways than by its back buffer: before the picture is there
// (shown_draws.cpp), or while the program prepares the next one (lagged_frame.cpp). A part of each Context,
// GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/window/lagged_frame.h"
#include "gl/window/presented_picture.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <optional>

namespace gluray::gl {

class Immediate;
class LayerDraws;
class ListCompiler;
class ResolveDraws;

class WindowFrames {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    Flusher& flusher;
    LayerDraws& layers;
    ResolveDraws& resolves;
    Immediate& immediate;
    ListCompiler& lists;
  };
  explicit WindowFrames(const Parts& parts) : p_(parts) {}

  // --- for intercept/, before a swap
  /// Whether all that it would show are a clear and what is pending.
  bool mayShowDirectly() noexcept;
  /// Then, instead of Context::beforeSwap() and the swap of a window of this size: traces what is pending and
  /// gives the picture to `show`. False: nothing was shown.
  bool showWithoutSwap(glm::ivec2 window, const ShowPicture& show) noexcept;
  /// In place of both where the frame can be shown later: it is traced meanwhile. Otherwise says why not.
  LagRefusal lag(const LagWindow& window) noexcept;

  /// Whether a frame waits that was swapped.
  bool lags() const { return lagged_.has_value(); }
  /// Shows it, before the window's buffers are looked at or drawn into.
  void showLagged();
  /// Whether a clear may come after that, too: then it is not to be made.
  bool clearsLater(GLbitfield mask);
  /// Whether a picture is shown that the back buffer does not hold.
  bool shows() const { return presented_.waiting.has_value(); }
  /// The back buffer is made to hold what is shown: at once, or where the window is drawn into.
  void settle();
  void settleBelow();
  /// Before the draw framebuffer is cleared.
  void clears(GLbitfield mask);
  /// Whether a draw that is kept for such frames reads textures, or that buffer as one.
  bool readsImages() const;
  bool readsBuffer(GLuint buffer) const;

 private:
  LagRefusal whyNotLag(GLenum buffer) const;
  void noteBegin();
  bool showsDirectly(const LaggedFrame& frame);
  PresentResult presentLagged(LaggedFrame& frame);

  PresentedPicture presented_;
  std::optional<LaggedFrame> lagged_;
  Parts p_;
};

}  // namespace gluray::gl
