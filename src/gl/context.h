// One OpenGL context as we see it: the parts that capture, decide, flush and show, and what generated stubs
// call. Made by intercept/; used by stubs and handlers, always on the thread where the context is current.
#pragma once
#include "gl/attention.h"
#include "gl/batch/batch_filler.h"
#include "gl/batch/flusher.h"
#include "gl/batch/resolve_draws.h"
#include "gl/capture/immediate.h"
#include "gl/draws/raster_draws.h"
#include "gl/draws/triage.h"
#include "gl/errors.h"
#include "gl/failsafe.h"
#include "gl/layers/layer_draws.h"
#include "gl/lists/list_compiler.h"
#include "gl/programs/program_draws.h"
#include "gl/state/attrib_stack.h"
#include "gl/state/shadow_state.h"
#include "gl/thread_state.h"
#include "gl/window/frame_ends.h"
#include "gl/window/frame_settings.h"
#include "gl/window/fullscreen_passes.h"
#include "gl/window/window_frames.h"

#include <memory>
#include <utility>
#include <vector>

namespace gluray::gl {

/// What a generated stub must do when `attention` is set.
enum class Gate {
  run,      // go on
  forward,  // call the real OpenGL only
  refuse,   // an error was recorded; return 0
  compile,  // a display list is being compiled
};

class Context {
 public:
  /// The real context must be current, now or when the first call arrives.
  static std::shared_ptr<Context> create(const RealGl& real, std::shared_ptr<ShareGroup> group,
                                         const ContextInfo& info, Presenter& presenter);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The parts, each with a job of its own: its header says which, and what it needs of the others.
  const RealGl& real;
  Attention attention;
  Errors errors;
  Failsafe failsafe;
  FrameSettings settings;
  ShadowState shadow;
  FrameClock clock;
  DrawCounts counts;
  SurfaceHistory surfaces;
  ClearedFramebuffers cleared;
  Flusher flusher;
  Triage triage;
  BatchFiller filler;
  RasterDraws raster;
  LayerDraws layers;
  ResolveDraws resolves;
  WindowFrames window;
  PassthroughFrames passthrough;
  FrameEnds frames;
  FullscreenPasses fullscreen;
  ProgramDraws programs;
  Immediate immediate;
  ListCompiler lists;
  AttribStack attribStack;

  // --- for generated stubs
  /// `anywhere`: the command is legal between glBegin and glEnd and deals with runs and lists itself.
  /// `compiled`: lists take it.
  Gate gate(bool anywhere = false, bool compiled = true) noexcept;
  /// Before a command that we do not model is forwarded: attributes are sent, and the batch too if it may
  /// matter.
  /// look: it draws nothing, but looks at what was drawn; leave: later draws go to another framebuffer, but
  /// nobody looks; redirect: so they do, or what pending draws need changes.
  enum class Flush { none, look, leave, redirect, all };
  void beforeForward(Flush flush) noexcept;
  void count(int command) noexcept { ++unknownCalls_[static_cast<size_t>(command)]; }
  void touch(uint32_t groups) { shadow.touch(groups); }
  void syncCurrent() { shadow.syncCurrent(); }
  template <class F>
  auto protect(F&& body) noexcept -> decltype(body()) {
    return failsafe.protect(std::forward<F>(body));
  }

  // --- for intercept/
  /// Called on the thread where the context has just been made current, or is about to lose it.
  void makeCurrent();
  void loseCurrent();
  /// Calls of commands that we do not model, by index into kCommandNames.
  const std::vector<Counter<uint64_t>>& unknownCalls() const { return unknownCalls_; }
  const ContextInfo& info() const { return shadow.info; }

 private:
  Context(const RealGl& real, std::shared_ptr<ShareGroup> group, const ContextInfo& info,
          Presenter& presenter);
  void drawHeld();

  std::vector<Counter<uint64_t>> unknownCalls_;
};

}  // namespace gluray::gl
