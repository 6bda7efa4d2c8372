// The pending batch, and its way into the framebuffer: settle, flush, present. A part of each Context, GL
// thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/presenter.h"
#include "gl/batch/unresolved_picture.h"
#include "gl/draws/draw_counts.h"
#include "gl/draws/surface_history.h"
#include "gl/failsafe.h"
#include "gl/state/shadow_state.h"
#include "gl/window/cleared_framebuffers.h"
#include "gl/window/frame_clock.h"

#include <GL/gl.h>

#include <optional>
#include <vector>

namespace gluray::gl {

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
  };
  Flusher(const Parts& parts, Presenter& with) : presenter(with), p_(parts) {}

  Batch batch;
  Presenter& presenter;

  /// Whether pictures of ours can be shown by this OpenGL.
  bool canTrace();
  /// Traces the pending batch and writes it into the framebuffer. Nothing to do if there is none.
  void flush() {
    settle();
    flushBatch();
  }
  /// The same of the batch alone, not of pictures that wait for being resolved.
  void flushBatch();
  /// The same where what is drawn next goes elsewhere, but nobody looks at what was drawn so far.
  void redirect() {
    settle();
    present();
  }
  /// The same where another framebuffer is bound: the batch may wait for being resolved.
  void leave();
  /// Traces the batch or, for a reason, has the real OpenGL draw it.
  void present(Reason reason = Reason::traced);
  /// Presents what was held back, into the framebuffer of its time. `known`: its picture is.
  void presentLate(const BatchKey& key, const scene::SnapshotPtr& snapshot, std::vector<ProgramDraw> draws,
                   bool known);
  /// Counts what came of a picture. `known`: it was shown before, elsewhere.
  void takeResult(const PresentResult& result, bool known = false);
  /// Writes pictures that wait elsewhere into their framebuffers: all, or those that a draw of now may meet.
  void settle();
  void settleBelow(int samples);
  /// Before the draw framebuffer is cleared: as redirect(), but that what the clear hides is let go. What is
  /// clean then, for ResolveDraws::cleanIs() after the real clear.
  UnresolvedPicture::Cleared beforeClear(GLbitfield mask);
  /// Before a glBlitFramebuffer that ResolveDraws::byBlit() does not do.
  void beforeBlit() noexcept;
  /// Before images of textures, or a buffer's contents, change: draws that are kept with their names are
  /// made.
  void imagesChange() noexcept;
  void contentsChange(GLuint buffer) noexcept;

 private:
  Parts p_;
  std::optional<bool> supported_;
};

}  // namespace gluray::gl
