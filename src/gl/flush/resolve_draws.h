// Keeps a traced image of a multisampled framebuffer until the program resolves it, and then writes the
// resolved pixels only (ADR 0020). A part of each Context, GL thread.
#pragma once
#include "gl/batch/presenter.h"
#include "gl/batch/unresolved_image.h"
#include "gl/counts/draw_kinds.h"
#include "gl/pending/pending_batch.h"

#include <GL/gl.h>

namespace gluray::gl {

class ComposedViews;
class WindowFrames;
struct Blit;

class ResolveDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    PendingBatch& pending;
    WindowFrames& window;
    ComposedViews& composed;
  };
  explicit ResolveDraws(const Parts& parts) : p_(parts) {}

  /// What a clear will leave clean. Pass it to clears() before the real clear, and to cleanIs() after it.
  UnresolvedImage::Cleared clearedBy(GLbitfield mask);
  void clears(const UnresolvedImage::Cleared& cleared);
  void cleanIs(const UnresolvedImage::Cleared& cleared) { p_.pending.unresolved.cleared = cleared; }

  /// Whether an image waits to be resolved; whether one waits or a framebuffer is clean.
  bool waits() const { return p_.pending.unresolved.waiting.has_value(); }
  bool any() const { return p_.pending.unresolved.any(); }
  /// Whether one of the waiting image's draws reads `buffer` as a texture.
  bool readsBuffer(GLuint buffer) const {
    return waits() && p_.pending.unresolved.waiting->batch.readsBuffer(buffer);
  }
  /// Takes the pending batch, which then waits to be resolved. False: it must not wait.
  bool hold();
  /// Writes the waiting image's samples into its framebuffer.
  void settle();
  /// Writes all delayed images into their framebuffers: composed ones, the window's, and this one.
  void settleAll();
  /// Resolves the waiting image in place of the program's draw, or of a blit. False: nothing was done.
  bool byProgram(GLuint texture, const scene::Region& region);
  bool byBlit(const Blit& blit);
  /// Call before a rasterised draw; before a blit.
  void meetRasterDraw();
  void meetBlit();

 private:
  bool readsSamples();
  bool blitsSamples();
  bool into(ResolveTarget& target);

  Parts p_;
};

}  // namespace gluray::gl
