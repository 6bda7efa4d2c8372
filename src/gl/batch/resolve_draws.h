// Multisampled framebuffers that are cleared, traced into and resolved. A part of each Context, GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/batch/presenter.h"
#include "gl/batch/unresolved_picture.h"
#include "gl/draws/draw_kinds.h"

#include <GL/gl.h>

namespace gluray::gl {

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
    Flusher& flusher;
    WindowFrames& window;
  };
  explicit ResolveDraws(const Parts& parts) : p_(parts) {}

  /// What a clear will leave clean: for clears() before the real one, and cleanIs() after it.
  UnresolvedPicture::Cleared clearedBy(GLbitfield mask);
  void clears(const UnresolvedPicture::Cleared& cleared);
  void cleanIs(const UnresolvedPicture::Cleared& cleared) { held_.cleared = cleared; }

  /// Whether a picture waits for being resolved; whether that, or what may become one, is known.
  bool waits() const { return held_.waiting.has_value(); }
  bool any() const { return held_.any(); }
  /// Whether a draw that is kept for it reads that buffer as a texture.
  bool readsBuffer(GLuint buffer) const { return waits() && gl::readsBuffer(held_.waiting->draws, buffer); }
  /// Takes the batch where it may wait for being resolved.
  bool hold();
  /// Writes what waits into its framebuffer.
  void settle();
  /// Resolves it where the current program's draw, or a blit, would. False: they are to do it.
  bool byProgram(GLuint texture, const scene::Region& region);
  bool byBlit(const Blit& blit);
  /// Before a rasterised draw, and a blit.
  void meetRasterDraw();
  void meetBlit();

 private:
  bool readsSamples();
  bool blitsSamples();
  bool into(ResolveTarget& target);

  UnresolvedPicture held_;
  Parts p_;
};

}  // namespace gluray::gl
