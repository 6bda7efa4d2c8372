// Draws of the real OpenGL among traced ones: what must be shown before them, and which traced surfaces they
// lie upon. A part of each Context, GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/capture/mesh_cache.h"
#include "gl/draws/draw_kinds.h"
#include "gl/draws/multipass_surfaces.h"
#include "gl/draws/triage.h"

#include <span>

namespace gluray::gl {

class RasterDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    Flusher& flusher;
    Triage& triage;
    LayerDraws& layers;
    ResolveDraws& resolves;
    WindowFrames& window;
  };
  explicit RasterDraws(const Parts& parts) : p_(parts) {}

  /// Makes the real OpenGL ready for a draw of its own: order, attributes.
  void before(PrimitiveClass kind);

  // Surfaces that are drawn in several passes.
  /// Whether a surface that is rasterised now may lie upon others of its depth epoch, so that it matters
  /// which depth those left. Its triangles are then to be shown to meet(), before before().
  bool mayMeet(PrimitiveClass kind) const;
  void meet(std::span<const Triangle> triangles);
  /// The surfaces that were found to have another pass get the depth of the real OpenGL.
  void rasteriseMet(MultipassSurfaces::Meeting meeting);
  /// Whether a rasterised draw leaves depth for passes that come: after meet() it is then given to
  /// remember().
  bool isPass(PrimitiveClass kind, Reason reason) const;
  void remember(const KnownMesh& known);

 private:
  Parts p_;
};

}  // namespace gluray::gl
