// Traces the pending batch and writes it into the framebuffer. Also writes images that were traced or
// delayed earlier ("settles" them). A part of each Context, GL thread.
#pragma once
#include "gl/batch/unresolved_image.h"
#include "gl/pending/batch_flush.h"
#include "gl/pending/pending_batch.h"

#include <GL/gl.h>

namespace gluray::gl {

class ComposedViews;
class Relighting;
class LayerDraws;
class ResolveDraws;
class WindowFrames;

class Flusher final : public BatchFlush {
 public:
  /// What the flusher needs of its context; all outlive it.
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    PendingBatch& pending;
    LayerDraws& layers;
    ResolveDraws& resolves;
    WindowFrames& window;
    ComposedViews& composed;
    Relighting& relighting;
  };
  explicit Flusher(const Parts& parts) : p_(parts) {}

  /// Settles delayed images, then traces the pending batch, if any, and writes it into the framebuffer.
  void flush() {
    settle();
    flushBatch();
  }
  void flushBatch() override;
  /// flush() for a command that sends later draws elsewhere and reads nothing: held peels may wait on.
  /// Rasterised surfaces, too, wait on to be captured.
  void redirect() {
    settle();
    if (!p_.pending.batch.empty()) present();
  }
  /// The same for a glBindFramebuffer: the batch may stay pending until it is resolved (ResolveDraws).
  void leave();
  /// Traces the batch or, for any other `reason`, has the real OpenGL draw it; also where limits of address
  /// space leave too little for both.
  void present(Reason reason = Reason::traced);
  /// Writes delayed images into their framebuffers: all, or those that a draw with so many samples into the
  /// current framebuffer may overlap.
  void settle();
  void settleBelow(int samples);
  /// Call before the draw framebuffer is cleared: presents the batch, and drops or settles delayed images.
  /// Returns what is clean then, for ResolveDraws::cleanIs() after the real clear.
  UnresolvedImage::Cleared beforeClear(GLbitfield mask);
  /// Call before a glBlitFramebuffer that ResolveDraws::byBlit() does not make.
  void beforeBlit(GLbitfield mask) noexcept;
  /// Call before texture images, or a buffer's contents, change: flushes if pending draws read them.
  void imagesChange() noexcept;
  void contentsChange(GLuint buffer) noexcept;

 private:
  void presentBatch(Reason reason);

  Parts p_;
};

}  // namespace gluray::gl
