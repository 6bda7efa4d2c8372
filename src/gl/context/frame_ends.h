// Decides when frames begin and end. They end at swaps and, in windows with one buffer, at glFlush and
// glFinish. In contexts that never swap they end where a framebuffer is cleared again whose picture is
// finished: it was read, copied or flushed, or the context was left. A part of each Context, GL thread.
#pragma once
#include "gl/clock/frame_settings.h"
#include "gl/context/passthrough_frames.h"
#include "gl/counts/draw_counts.h"
#include "gl/flush/flusher.h"
#include "gl/flush/relighting.h"
#include "gl/window/window_frames.h"

#include <GL/gl.h>

namespace gluray::gl {

class Immediate;
class ListCompiler;
class ResolveDraws;

class FrameEnds {
 public:
  struct Parts {
    FrameSettings& settings;
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    PendingBatch& pending;
    Flusher& flusher;
    Relighting& relighting;
    ResolveDraws& resolves;
    WindowFrames& window;
    PassthroughFrames& passthrough;
    Immediate& immediate;
    const ListCompiler& lists;
  };
  explicit FrameEnds(const Parts& parts) : p_(parts), sourceFrame_(parts.settings.sourceFrame()) {}

  /// For intercept/, in place of beforeSwap() and the swap: WindowFrames::mayShowDirectly() and lag().
  bool mayShowDirectly() noexcept;
  LagRefusal lag(const LagWindow& window) noexcept;
  /// Call before a buffer swap: writes all pending images into the window.
  void beforeSwap();
  /// Call after a buffer swap: ends the frame, chooses the next one's engine, forgets old meshes.
  void afterSwap();
  /// For glFlush: flushes if the pending batch could be seen before the next swap, by contexts that share the
  /// images of its framebuffer object, or in the window.
  void showIfVisible() { show(false, false); }
  /// For glFinish: the same, and whatever uses of the framebuffer could follow without a call of this
  /// context.
  void finish();
  /// Call before a clear: if the frame begins with it, takes the current settings.
  void beforeClear(GLbitfield mask) noexcept;
  /// Call before and after the real clear. Clears of colour and depth end frames of programs that never swap.
  void clearing(GLbitfield mask);
  void cleared(GLbitfield mask);

 private:
  void takeSettings();
  void endWithOthers(GLbitfield mask);
  void endInMemory(GLbitfield mask);
  uint64_t draws() const;
  void nextFrame();
  void endFrame();
  void endFrameInPlace();
  void endDepths();
  void endViews(GLbitfield mask);
  /// Flushes in any case into framebuffer objects if `objects`, into windows if `windows`.
  void show(bool objects, bool windows);
  void showFront();
  void showDrawn();
  void chooseEngine();
  void forgetOld();
  void deleteDiscarded();

  Parts p_;
  bool begun_ = false;          // this frame has cleared
  GLuint firstCleared_ = 0;     // the framebuffer that this frame cleared last before its first draw
  bool hasSwapped_ = false;     // or finished, in windows with one buffer: frames with draws
  int picturesSinceSwap_ = 0;   // if so
  uint64_t drawsBefore_ = 0;    // draws before this frame
  uint64_t sourceFrame_;        // FrameSettings::sourceFrame() when a frame was begun last
  bool othersSwap_ = false;     // frames end with those of another context
  uint64_t drawsInFront_ = 0;   // draws up to the last frame in the front buffer
  int clears_ = 0;              // clears of colour and depth since forgetOld()
  uint64_t workForgotten_ = 0;  // DrawCounts::work() at the last forgetOld()
};

}  // namespace gluray::gl
