// Peels after the first one, whose layers are already traced. They are held back until the program has drawn
// enough peels to show all layers. The program decides when to stop by occlusion queries; these count the
// pixels that the peels would have written. A part of LayerDraws, GL thread.
#pragma once
#include "gl/batch/presenter.h"
#include "gl/layers/held_peels.h"

namespace gluray::gl {

class LaterPeels {
 public:
  /// `held` must outlive it.
  LaterPeels(const LayerParts& parts, HeldPeels& held) : p_(parts), held_(held), peeling_(held.peeling()) {}

  /// Whether the first peel's layers may wait for later peels.
  bool mayAsk() const;
  /// The first peel's layers are traced, and wait: HeldPeels::asks().
  void ask(PresentResult& result);
  /// While asks(): holds back a draw of a later peel, or the draw, counted by a query, that blends the peel's
  /// farthest layers. Returns false if nothing is held back any more, and the draw must be made or traced.
  bool holdLater(GLenum mode, const Elements& elements);
  /// After such an image was shown: whether the draw would only blend remaining layers, and none remain.
  bool drawsNothing();
  /// While asks(): holds back a clear. Returns false if the clear must be made.
  bool clearsLater(GLbitfield mask) noexcept;
  /// Call before glBeginQuery.
  void queryBegins(GLenum target, GLuint name);

 private:
  bool joinsFirstPeel() const;
  bool addPeel(GLenum mode, const Elements& elements);
  bool addBlended(GLenum mode, const Elements& elements);
  bool blendsRest() const;
  bool traceAgain(uint32_t peels);
  bool showWaiting();

  LayerParts p_;
  HeldPeels& held_;
  Peeling& peeling_;  // that of held_
};

}  // namespace gluray::gl
