// Draws of transparent surfaces (layers): peeled in depth order (peel_draws.cpp, later_peels.cpp), summed
// without order (sum_draws.cpp) or blended in drawing order (drawn_layers.cpp). Decides whether they can be
// traced, starts their batches and presents peeled ones. A part of each Context, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/batch/batch.h"
#include "gl/batch/presenter.h"
#include "gl/counts/draw_kinds.h"
#include "gl/layers/peeling.h"
#include "gl/pending/batch_flush.h"
#include "gl/pending/pending_batch.h"

namespace gluray::gl {

struct Elements;

/// The pass that the shader program's family describes; `none` if there is none.
Family::Pass passOf(const ProgramState& program);
/// The kind of layers that the program draws in this pass; `none` if there is none.
BatchKey::Layers layersOf(const ProgramState& program);

class LayerDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    ClearedFramebuffers& cleared;
    PendingBatch& pending;
    BatchFlush& flush;
  };
  explicit LayerDraws(const Parts& parts) : p_(parts) {}

  /// Why a surface of the current shader program cannot be traced in the first peel, or Reason::traced. After
  /// any later rasterised draw, nothing is held back any more (meetRasterDraw()).
  Reason classifyPeel(PrimitiveClass kind);
  /// The same for layers that are summed.
  Reason classifySum(PrimitiveClass kind);
  /// Holds back a draw of the depth pass before the first peel. Returns false if the draw must be made
  /// instead.
  bool holdDepths(GLenum mode, const Elements& elements, uint64_t triangles);
  /// Begins a batch of layers, whose first surface has this modelview matrix, or reopens the pending or
  /// traced one. Returns false if it has another key, or no depth can be read.
  bool start(const BatchKey& key, const glm::dmat4& modelview);

  /// Whether draws are held back, or more surfaces may join those traced.
  bool pending() const { return peeling_.stage != Peeling::Stage::none; }
  /// Whether draws need not consider layers.
  bool idle() const { return !pending() && !peeling_.emptied; }
  bool holdsDepths() const { return peeling_.stage == Peeling::Stage::depths; }
  /// Whether traced layers wait until the number of the program's peels is known. Meanwhile the program's
  /// clears and draws are held back.
  bool asks() const { return peeling_.stage == Peeling::Stage::peels; }
  /// Whether anything is held back that a flush must draw.
  bool holdsBack() const { return holdsDepths() || asks(); }
  /// While asks(): holds back a draw of a later peel, or the draw, counted by a query, that blends the peel's
  /// farthest layers. Returns false if nothing is held back any more, and the draw must be made or traced.
  bool holdLater(GLenum mode, const Elements& elements);
  /// After such an image was shown: whether the draw would only blend remaining layers, and none remain.
  bool drawsNothing();
  /// While asks(): holds back a clear. Returns false if the clear must be made.
  bool clearsLater(GLbitfield mask) noexcept;
  /// Call before glBeginQuery.
  void queryBegins(GLenum target, GLuint name);
  /// Key of the layers that were already traced; null if there are none.
  const BatchKey* tracedKey() const { return peeling_.traced ? &peeling_.tracedKey : nullptr; }
  /// Whether the batch contains more than surfaces with transparent textures, such as labels. A batch of
  /// labels alone is rasterised, so that they stay sharp.
  bool haveSurfaces() const;
  /// Traces the batch's layers into the program's textures.
  PresentResult present(const scene::SnapshotPtr& snapshot, const BatchKey& key);
  /// Makes the real OpenGL draw everything that was held back.
  void giveUp();

  /// Whether surfaces that are not opaque, or write no depth, can now be traced as layers that are blended in
  /// drawing order.
  bool mayBeDrawn() const;
  /// Whether the real OpenGL draws such a surface of `triangles` triangles, because that is faster.
  bool leavesDrawn(uint64_t triangles);
  /// Sets the fields of `key` that such surfaces need.
  void describe(BatchKey& key, BatchKey::DrawnBy drawnBy) const;
  /// Call before such a batch is taken: reads the colour and depth below it. Returns false if they cannot be
  /// read.
  bool readUnder();

  /// Call before a rasterised draw.
  void meetRasterDraw();
  /// Call before a clear of the draw framebuffer.
  void clearing();
  /// Call before a shader program is linked again or deleted.
  void programChanges(GLuint program) noexcept;

 private:
  bool peelsIntoAll() const;
  bool beginHolding();
  bool startPeeled(const BatchKey& key, const glm::dmat4& modelview);
  bool startSums(const BatchKey& key, const glm::dmat4& modelview);
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
  Reason classifySeenThrough(PrimitiveClass kind);  // the common part of both

  Peeling peeling_;
  /// The surfaces of a frame that could be blended in drawing order, traced or not.
  struct Drawn {
    uint64_t triangles = 0;
    uint64_t runs = 0;  // sequences of consecutive such draws with equal blending
  };
  Drawn drawn_, lastDrawn_;  // of this frame and of the previous one
  uint64_t frame_ = 0;       // frame number of drawn_
  uint64_t drawnLast_ = 0;   // number of the last such draw
  scene::Blending drawnBy_;
  Parts p_;
};

}  // namespace gluray::gl
