// Prepares rasterised draws among traced ones: flushes what must be shown before them, and finds the traced
// surfaces that they coincide with. A part of each Context, GL thread.
#pragma once
#include "gl/capture/mesh_cache.h"
#include "gl/classify/triage.h"
#include "gl/counts/draw_kinds.h"
#include "gl/flush/flusher.h"
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
    Triage& triage;
    LayerDraws& layers;
    ResolveDraws& resolves;
    WindowFrames& window;
    ComposedViews& composed;
  };
  explicit RasterDraws(const Parts& parts) : p_(parts) {}

  /// Call before a rasterised draw: flushes earlier draws if order matters, and sends current attributes.
  void before(PrimitiveClass kind);
  /// The clear that the framebuffer held, and nothing else, when before() was called last.
  const std::optional<ClearedTarget>& clearBelow() const { return clearBelow_; }

  // Surfaces that are drawn in several passes.
  /// Whether the vertices of a surface that is rasterised now for this reason are needed, because it may
  /// coincide with others of its depth epoch. If so, call meetPasses().
  bool needsVertices(PrimitiveClass kind, Reason reason) const;
  /// Call before before(). `sample()` returns some of its triangles, `meshOf()` its KnownMesh; each is called
  /// if it is needed. Both may throw.
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
  /// The same for a draw whose triangles are not sampled.
  void noteUnsampledDraw(PrimitiveClass kind, Reason reason);
  /// Has the real OpenGL draw the depth of the traced surfaces that were found to have another pass.
  void rasteriseMet(MultipassSurfaces::Meeting meeting);

 private:
  /// What is done with a surface that is rasterised.
  struct Needs {
    bool meets = false;      // it is compared with earlier surfaces
    bool mesh = false;       // later surfaces are compared with its mesh
    bool leaves = false;     // later surfaces are compared with a sample of its triangles
    bool unsampled = false;  // later surfaces count as coincident with it
    bool any() const { return meets || mesh || leaves; }
  };
  Needs needsOf(PrimitiveClass kind, Reason reason) const;
  /// Whether draws now take their vertices from fixed function, and so may have its depths.
  bool hasFixedVertices() const;
  void meet(std::span<const Triangle> triangles);
  void remember(const KnownMesh& known);
  void leave(std::vector<Triangle> triangles);
  void addUnsampledFixedDraw();
  DepthPlace depthPlace() const;
  /// Which way the next draw may change depths.
  void noteDepths();

  Parts p_;
  std::optional<ClearedTarget> clearBelow_;
};

}  // namespace gluray::gl
