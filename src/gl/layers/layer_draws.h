// Draws of surfaces that are seen through: peeled in depth order (peel_draws.cpp), added up without order
// (sum_draws.cpp) or blended in the order of drawing (drawn_layers.cpp). A part of each Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/flusher.h"
#include "gl/batch/presenter.h"
#include "gl/draws/draw_kinds.h"
#include "gl/draws/reasons.h"
#include "gl/layers/peeling.h"

namespace gluray::gl {

struct Elements;

/// What passes of the program are for, and how surfaces that it draws are seen through, if they are.
Family::Pass passOf(const ProgramState& program);
BatchKey::Layers layersOf(const ProgramState& program);

class LayerDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    ClearedFramebuffers& cleared;
    Flusher& flusher;
  };
  explicit LayerDraws(const Parts& parts) : p_(parts) {}

  /// Why a surface of the current program cannot be traced in the first peel, or Reason::traced. Whoever then
  /// draws otherwise makes us give up. Call refresh(kProgramGroups) before.
  Reason triagePeel(PrimitiveClass kind);
  /// The same of surfaces that are added up.
  Reason triageSum(PrimitiveClass kind);
  /// Holds back a draw of the pass before the first peel. False: draw it.
  bool holdDepths(GLenum mode, const Elements& elements, uint64_t triangles);
  /// Begins a batch of layers, or finds that the one which waits may take more. False: it may not.
  bool start(const BatchKey& key);

  /// Whether draws are held back, or others may join what has been traced.
  bool pending() const { return peeling_.stage != Peeling::Stage::none; }
  bool holdsDepths() const { return peeling_.stage == Peeling::Stage::depths; }
  /// Whether layers are traced that wait until it is known how many peels the program draws; what it clears
  /// and draws meanwhile is held back.
  bool asks() const { return peeling_.stage == Peeling::Stage::peels; }
  /// Then: holds back a draw of a later peel, or of what is counted. False: it is to be drawn
  /// or traced, nothing of that kind is held any more.
  bool holdLater(GLenum mode, const Elements& elements);
  /// After such a picture was shown: whether the draw is what peels have left, of which there is nothing.
  bool drawsNothing();
  /// And a clear. False: make it.
  bool clearsLater(GLbitfield mask) noexcept;
  /// Before a query that counts draws.
  void queryBegins(GLenum target, GLuint name);
  /// Of the layers that are shown already, if there are any.
  const BatchKey* tracedKey() const { return peeling_.traced ? &peeling_.tracedKey : nullptr; }
  /// Whether there is more in the batch than pictures with holes, such as labels: those are to be as sharp as
  /// ever.
  bool haveSurfaces() const;
  /// Traces the batch's layers into the program's textures.
  PresentResult present(const scene::SnapshotPtr& snapshot, const BatchKey& key);
  /// What was held back is drawn by the real OpenGL after all.
  void giveUp();

  /// Whether fixed-function surfaces that are not opaque, or that leave no depth, can be traced in the state
  /// of now, in the order of drawing.
  bool mayBeDrawn() const;
  /// Whether such a surface of so many triangles, which is about to be drawn, is left to the real OpenGL
  /// because that is faster.
  bool leavesDrawn(uint64_t triangles);
  /// Makes a batch's key that of such surfaces.
  void describe(BatchKey& key) const;
  /// Before such a batch is taken: reads what it is drawn over. False where that cannot be read.
  bool readUnder();

  /// Before a rasterised draw, a clear of the draw framebuffer, and a program that is linked anew or deleted.
  void meetRasterDraw();
  void clearing();
  void programChanges(GLuint program) noexcept;

 private:
  bool peelsIntoAll() const;
  bool beginHolding();
  bool startPeeled(const BatchKey& key);
  bool startSums(const BatchKey& key);
  bool mayAsk() const;
  bool joinsFirstPeel() const;
  void ask(PresentResult& result);
  bool addPeel(GLenum mode, const Elements& elements);
  bool addBlended(GLenum mode, const Elements& elements);
  bool blendsRest() const;
  bool traceAgain(uint32_t peels);
  bool showWaiting();
  void end();
  void countHeld();
  Reason triageSeenThrough(PrimitiveClass kind);  // what both kinds have in common

  Peeling peeling_;
  /// Surfaces of a frame that could be blended in the order of drawing, traced or not.
  struct Drawn {
    uint64_t triangles = 0;
    uint64_t runs = 0;  // of such draws, one after the other, of one state
  };
  Drawn drawn_, lastDrawn_;
  uint64_t frame_ = 0;      // that drawn_ is of
  uint64_t drawnLast_ = 0;  // the last one: number of the draw
  scene::Blending drawnBy_;
  Parts p_;
};

}  // namespace gluray::gl
