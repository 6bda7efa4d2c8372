// Owns the pending batch, traces it and writes it into the framebuffer. Also writes pictures that were traced
// or delayed earlier ("settles" them). A part of each Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/pictured_surfaces.h"
#include "gl/batch/presenter.h"
#include "gl/batch/unresolved_picture.h"
#include "gl/draws/draw_counts.h"
#include "gl/draws/surface_history.h"
#include "gl/failsafe.h"
#include "gl/state/shadow_state.h"
#include "gl/window/cleared_framebuffers.h"
#include "gl/window/frame_clock.h"

#include <GL/gl.h>

#include <memory>
#include <optional>
#include <vector>

namespace gluray::gl {

class ComposedViews;
class LayerDraws;
class ResolveDraws;
class WindowFrames;

class Flusher {
 public:
  /// What the flusher needs of its context; all outlive it.
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    LayerDraws& layers;
    ResolveDraws& resolves;
    WindowFrames& window;
    ComposedViews& composed;
  };
  Flusher(const Parts& parts, Presenter& with)
      : presenter(with), pictured({parts.shadow, parts.clock, parts.surfaces, with}), p_(parts) {}

  Batch batch;
  Presenter& presenter;
  PicturedSurfaces pictured;

  /// Whether this OpenGL can show traced pictures (Presenter::supports()). The first call builds shaders.
  bool canTrace();
  /// Whether canTrace() was called.
  bool knowsSupport() const { return supported_.has_value(); }
  /// Settles delayed pictures, then traces the pending batch, if any, and writes it into the framebuffer.
  void flush() {
    settle();
    flushBatch();
  }
  /// Flushes the batch alone, without settling.
  void flushBatch();
  /// The program begins to draw what will be traced: how light is sampled for it.
  scene::LightSampling::Mode begin();
  /// flush() for a command that sends later draws elsewhere and reads nothing: held peels may wait on.
  /// Rasterised surfaces, too, wait on to be pictured.
  void redirect() {
    settle();
    if (!batch.empty()) present();
  }
  /// The same for a glBindFramebuffer: the batch may stay pending until it is resolved (ResolveDraws).
  void leave();
  /// Traces the batch or, for any other `reason`, has the real OpenGL draw it; also where limits of address
  /// space leave too little for both.
  void present(Reason reason = Reason::traced);
  /// Presents a delayed snapshot into the framebuffer of `key`. `known`: its picture is traced already. The
  /// real OpenGL draws it where limits of address space leave too little for compiling what writes pictures.
  void presentLate(const BatchKey& key, const scene::SnapshotPtr& snapshot, std::vector<ProgramDraw> draws,
                   bool known);
  /// Numbers the surfaces of the pending batch, and tells it what surrounds it. Call before it is traced or
  /// taken.
  void surround();
  /// Peeled layers that were traced are drawn by the real OpenGL after all: they light nothing.
  void withdrawPeeled() noexcept { p_.surfaces.views.withdrawPeeled(p_.clock.frame); }
  /// Adds a result to the statistics. `known`: the picture was shown before, elsewhere.
  void takeResult(const PresentResult& result, bool known = false);
  /// Writes delayed pictures into their framebuffers: all, or those that a draw with so many samples into the
  /// current framebuffer may overlap.
  void settle();
  void settleBelow(int samples);
  /// Call before the draw framebuffer is cleared: presents the batch, and drops or settles delayed pictures.
  /// Returns what is clean then, for ResolveDraws::cleanIs() after the real clear.
  UnresolvedPicture::Cleared beforeClear(GLbitfield mask);
  /// Call before a glBlitFramebuffer that ResolveDraws::byBlit() does not make.
  void beforeBlit() noexcept;
  /// Call before texture images, or a buffer's contents, change: flushes if pending draws read them.
  void imagesChange() noexcept;
  void contentsChange(GLuint buffer) noexcept;

 private:
  std::shared_ptr<const scene::Backdrop> backdrop();
  void presentBatch(Reason reason);

  Parts p_;
  std::optional<bool> supported_;
};

}  // namespace gluray::gl
