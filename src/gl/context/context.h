// One OpenGL context: the parts that capture, decide, flush and show, and the functions that generated stubs
// call. intercept/ creates it; stubs and handlers use it, always on the thread where it is current.
#pragma once
#include "gl/basics/failsafe.h"
#include "gl/basics/thread_state.h"
#include "gl/classify/classifier.h"
#include "gl/classify/untraced_programs.h"
#include "gl/clock/frame_settings.h"
#include "gl/context/attention.h"
#include "gl/context/attrib_stack.h"
#include "gl/context/frame_ends.h"
#include "gl/context/fullscreen_passes.h"
#include "gl/context/immediate.h"
#include "gl/context/list_compiler.h"
#include "gl/culled/culled_draws.h"
#include "gl/draws/batch_filler.h"
#include "gl/draws/draws.h"
#include "gl/draws/program_draws.h"
#include "gl/draws/raster_draws.h"
#include "gl/flush/flusher.h"
#include "gl/flush/relighting.h"
#include "gl/flush/resolve_draws.h"
#include "gl/framebuffers/composed_views.h"
#include "gl/layers/layer_draws.h"
#include "gl/real/errors.h"
#include "gl/shadow/shadow_state.h"
#include "gl/volumes/volume_draws.h"
#include "gl/window/window_frames.h"

#include <memory>
#include <utility>
#include <vector>

namespace gluray::gl {

/// What a generated stub must do when `attention` is true.
enum class Gate {
  run,      // go on
  forward,  // call the real OpenGL only
  refuse,   // an error was recorded; return 0
  compile,  // a display list is being compiled
};

class Context {
 public:
  /// The real context must be current now or when the first call arrives.
  static std::shared_ptr<Context> create(const RealGl& real, std::shared_ptr<ShareGroup> group,
                                         const ContextInfo& info, Presenter& presenter);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The parts. Each one's header states its job and which other parts it uses.
  const RealGl& real;
  Attention attention;
  BeginEnd beginEnd;
  Errors errors;
  Failsafe failsafe;
  FrameSettings settings;
  ShadowState shadow;
  FrameClock clock;
  DrawCounts counts;
  SurfaceHistory surfaces;
  ClearedFramebuffers cleared;
  ComposedViews composed;
  PendingBatch pending;
  Relighting relighting;
  Flusher flusher;
  Classifier classifier;
  RasterDraws raster;
  BatchFiller filler;
  Draws draws;
  LayerDraws layers;
  ResolveDraws resolves;
  WindowFrames window;
  PassthroughFrames passthrough;
  FrameEnds frames;
  FullscreenPasses fullscreen;
  VolumeDraws volumes;
  UntracedPrograms untraced;
  ProgramDraws programs;
  CulledDraws culled;
  Immediate immediate;
  ListCompiler lists;
  AttribStack attribStack;

  // --- for generated stubs
  /// `command`: its name. `anywhere`: it is legal between glBegin and glEnd, and handles runs and lists
  /// itself. `compiled`: display lists record it.
  Gate gate(const char* command, bool anywhere = false, bool compiled = true) noexcept;
  /// Call before forwarding a command that we do not model: sends current attributes to the real OpenGL and
  /// flushes the batch. Flush describes the command. look: draws nothing, but reads what was drawn; read: the
  /// same, and the program gets the colours; leave: binds another framebuffer, reads nothing; redirect: sends
  /// later draws elsewhere, or changes what pending draws need, and reads nothing; all: may do anything.
  enum class Flush { none, look, read, leave, redirect, all };
  void beforeForward(Flush flush) noexcept {
    if (flush != Flush::none || attention.isNeeded()) [[unlikely]]
      prepareToForward(flush);
  }
  void count(int command) noexcept { ++unknownCalls_[static_cast<size_t>(command)]; }
  /// A command is about to change state of these groups.
  void touch(uint32_t groups) {
    if ((groups & ~uint32_t{kArrays}) && !(groups & kHeldNoted)) shadow.current.stateChanges();
    shadow.touch(groups);
  }
  /// A command makes the real OpenGL store the current values that it holds back.
  void storesCurrent() { shadow.current.stored(); }
  template <class F>
  auto protect(F&& body) noexcept -> decltype(body()) {
    return failsafe.protect(std::forward<F>(body));
  }

  // --- for intercept/
  /// Call on the context's thread after it was made current, and before it stops being current.
  /// `drawable`: that it draws into; 0: unknown.
  void makeCurrent(uintptr_t drawable = 0);
  void loseCurrent();
  /// Whether the drawable that it is current with has a back buffer.
  void setDoubleBuffered(bool doubleBuffered) { shadow.info.doubleBuffered = doubleBuffered; }
  /// Call counts of commands that we do not model, by index into kCommandNames.
  const std::vector<Counter<uint64_t>>& unknownCalls() const { return unknownCalls_; }
  const ContextInfo& info() const { return shadow.info; }

 private:
  Context(const RealGl& real, std::shared_ptr<ShareGroup> group, const ContextInfo& info,
          Presenter& presenter);
  void drawHeld();
  void prepareToForward(Flush flush) noexcept;

  std::vector<Counter<uint64_t>> unknownCalls_;
};

}  // namespace gluray::gl
