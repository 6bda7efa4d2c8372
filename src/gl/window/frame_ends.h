// When frames begin and end: by swaps, by glFlush and glFinish, or by clears of programs that draw into
// memory alone. A part of each Context, GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/draws/draw_counts.h"
#include "gl/window/frame_settings.h"
#include "gl/window/passthrough_frames.h"

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
    Flusher& flusher;
    ResolveDraws& resolves;
    WindowFrames& window;
    PassthroughFrames& passthrough;
    Immediate& immediate;
    const ListCompiler& lists;
  };
  explicit FrameEnds(const Parts& parts) : p_(parts) {}

  /// Shows what is pending, before a buffer swap, and after it.
  void beforeSwap();
  void afterSwap();
  /// For glFlush and glFinish: shows what is pending if anybody could see it before the next swap.
  void showIfVisible();
  /// Before a clear: where the frame begins with it, takes the settings of now.
  void beforeClear() noexcept;
  /// Before and after the real clear: of colour and depth they are the frames of programs that never swap.
  void clearing(GLbitfield mask);
  void cleared(GLbitfield mask);

 private:
  void takeSettings();
  uint64_t draws() const;
  void endFrame();
  void showFront();
  void showDrawn();
  void chooseEngine();
  void forgetOld();
  void deleteDiscarded();

  Parts p_;
  bool begun_ = false;          // this frame has cleared
  uint64_t drawsBefore_ = 0;    // draws until this frame
  uint64_t drawsInFront_ = 0;   // draws until the last frame in the front buffer
  int clears_ = 0;              // of colour and depth since forgetOld()
  uint64_t workForgotten_ = 0;  // DrawCounts::work() at that time
};

}  // namespace gluray::gl
