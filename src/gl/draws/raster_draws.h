// Prepares rasterised draws among traced ones: flushes what must be shown before them, and finds the traced
// surfaces that they coincide with. A part of each Context, GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/capture/mesh_cache.h"
#include "gl/draws/draw_kinds.h"
#include "gl/draws/multipass_surfaces.h"
#include "gl/draws/triage.h"

#include <optional>
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

  /// Call before a rasterised draw: flushes earlier draws if order matters, and sends current attributes.
  void before(PrimitiveClass kind);
  /// The clear that the framebuffer held, and nothing else, when before() was called last.
  const std::optional<ClearedTarget>& clearBelow() const { return clearBelow_; }

  // Surfaces that are drawn in several passes.
  /// Whether a surface that is rasterised now may coincide with others of its depth epoch, so that their
  /// exact depth matters. If so, pass its triangles to meet(), before before().
  bool mayMeet(PrimitiveClass kind) const;
  void meet(std::span<const Triangle> triangles);
  /// Has the real OpenGL draw the depth of the traced surfaces that were found to have another pass.
  void rasteriseMet(MultipassSurfaces::Meeting meeting);
  /// Whether later passes may compare with a rasterised draw's depth: then call remember() after meet().
  bool isPass(PrimitiveClass kind, Reason reason) const;
  void remember(const KnownMesh& known);

 private:
  /// Which way the next draw may change depths.
  void noteDepths();

  Parts p_;
  std::optional<ClearedTarget> clearBelow_;
};

}  // namespace gluray::gl
