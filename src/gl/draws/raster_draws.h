// Prepares rasterised draws among traced ones: flushes pending batches that must be drawn first, and finds
// coincident traced surfaces. A part of each Context, GL thread.
#pragma once
#include "gl/capture/mesh_cache.h"
#include "gl/classify/classifier.h"
#include "gl/counts/draw_kinds.h"
#include "gl/flush/flusher.h"
#include "gl/flush/relighting.h"
#include "gl/history/multipass_surfaces.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gluray::gl {

class RasterDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
    PendingBatch& pending;
    Flusher& flusher;
    Relighting& relighting;
    Classifier& classifier;
    LayerDraws& layers;
    ResolveDraws& resolves;
    WindowFrames& window;
    ComposedViews& composed;
  };
  explicit RasterDraws(const Parts& parts) : p_(parts) {}

  /// Call before a rasterised draw: flushes earlier draws if order matters, and sends current attributes.
  void before(PrimitiveClass kind);
  /// The clear values, if the framebuffer was only cleared before the last before().
  const std::optional<ClearedTarget>& clearBelow() const { return clearBelow_; }

  // Surfaces that are drawn in several passes.
  /// Whether the vertices of a surface that is rasterised for this reason are needed, because it may coincide
  /// with other surfaces of its depth epoch. If so, call meetPasses().
  bool needsVertices(PrimitiveClass kind, Reason reason) const;
  /// Call before before(). `sample()` returns a sample of the triangles, `meshOf()` the KnownMesh; both are
  /// called on demand and may throw.
  template <class Sample, class MeshOf>
  void meetPasses(PrimitiveClass kind, Reason reason, const Sample& sample, const MeshOf& meshOf) {
    const Needs needs = needsOf(kind, reason);
    if (needs.unsampled) addUnsampledFixedDraw();
    if (!needs.any()) return;
    p_.failsafe.protect([&] {
      std::vector<Triangle> triangles;
      if (needs.meets || needs.leaves) triangles = sample();
      if (needs.meets) meet(triangles);
      if (needs.mesh) remember(meshOf());
      if (needs.leaves) leave(std::move(triangles));
    });
  }
  /// Reports a draw whose triangles are not sampled.
  void noteUnsampledDraw(PrimitiveClass kind, Reason reason);
  /// Redraws the depth of traced surfaces with a further pass by the real OpenGL.
  void rasteriseMet(MultipassSurfaces::Meeting meeting);

 private:
  /// The steps for a rasterised surface.
  struct Needs {
    bool meets = false;      // it is compared with earlier surfaces
    bool mesh = false;       // later surfaces are compared with its mesh
    bool leaves = false;     // later surfaces are compared with a sample of its triangles
    bool unsampled = false;  // later surfaces count as coincident with it
    bool any() const { return meets || mesh || leaves; }
  };
  Needs needsOf(PrimitiveClass kind, Reason reason) const;
  /// Whether current draws use fixed-function vertices, and so may have fixed function's depths.
  bool hasFixedVertices() const;
  void meet(std::span<const Triangle> triangles);
  void remember(const KnownMesh& known);
  void leave(std::vector<Triangle> triangles);
  void addUnsampledFixedDraw();
  /// Records in which direction the next draw may change depths.
  void noteDepths();

  Parts p_;
  std::optional<ClearedTarget> clearBelow_;
};

}  // namespace gluray::gl
