// The depth pass and the first peel of dual depth peeling, whose surfaces are traced as layers. A part of
// LayerDraws, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/batch/presenter.h"
#include "gl/counts/draw_kinds.h"
#include "gl/layers/held_peels.h"
#include "gl/layers/later_peels.h"

namespace gluray::gl {

class PeelDraws {
 public:
  /// `held` and `later` must outlive it.
  PeelDraws(const LayerParts& parts, HeldPeels& held, LaterPeels& later)
      : p_(parts), held_(held), later_(later), peeling_(held.peeling()) {}

  /// Why a surface of the current shader program cannot be traced in the first peel, or Reason::traced. After
  /// any later rasterised draw, nothing is held back any more (meetRasterDraw()).
  Reason classify(PrimitiveClass kind);
  /// Holds back a draw of the depth pass before the first peel. Returns false if the draw must be made
  /// instead.
  bool holdDepths(GLenum mode, const Elements& elements, uint64_t triangles);
  /// As LayerDraws::start().
  bool start(const BatchKey& key, const glm::dmat4& modelview);
  /// Whether the batch contains more than surfaces with transparent textures, such as labels. A batch of
  /// labels alone is rasterised, so that they stay sharp.
  bool haveSurfaces() const;
  /// Traces the batch's layers into the program's textures.
  PresentResult present(const scene::SnapshotPtr& snapshot, const BatchKey& key);

  /// Call before a rasterised draw.
  void meetRasterDraw();
  /// Call before a clear of the draw framebuffer.
  void clearing();
  /// Call before a shader program is linked again or deleted.
  void programChanges(GLuint program) noexcept;

 private:
  bool beginHolding(GLenum mode, const Elements& elements);

  LayerParts p_;
  HeldPeels& held_;
  LaterPeels& later_;
  Peeling& peeling_;  // that of held_
};

}  // namespace gluray::gl
