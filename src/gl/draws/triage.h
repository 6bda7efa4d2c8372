// Traced or rasterised? What decides about draws of the fixed-function pipeline, and what all draws have in
// common. A part of each Context, GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/capture/mesh_cache.h"
#include "gl/draws/draw_kinds.h"
#include "gl/draws/reasons.h"
#include "gl/draws/surface_history.h"
#include "gl/failsafe.h"
#include "gl/state/shadow_state.h"
#include "gl/window/frame_clock.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::gl {

class LayerDraws;

class Triage {
 public:
  struct Parts {
    ShadowState& shadow;
    const Failsafe& failsafe;
    FrameClock& clock;
    SurfaceHistory& surfaces;
    Flusher& flusher;
    LayerDraws& layers;
  };
  explicit Triage(const Parts& parts) : p_(parts) {}

  /// What rules any draw out, whoever draws it: failures, queries, the framebuffer. Reason::traced: nothing.
  Reason ofContext() const;
  /// Why a surface of the fixed-function pipeline cannot be traced now, or Reason::traced. Call
  /// refresh(kDrawGroups) before.
  Reason of(PrimitiveClass kind) const;
  /// The same of a surface with this mesh.
  Reason of(const KnownMesh& mesh, const std::vector<MaterialChange>& materials);
  /// Whether one that can be traced is a layer, blended in the order of drawing (LayerDraws::mayBeDrawn()).
  bool isLayer(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;

  /// Whether surfaces are compared with the depth that is there.
  bool meetsDepth(PrimitiveClass kind) const;
  /// Whether surfaces are drawn with a polygon offset away from the viewer.
  bool isPushedBack() const;
  /// Where a draw that moves depth by `offset` puts its mesh now.
  SurfacePlace placeOf(const glm::dmat4& clipFromObject, scene::PolygonOffset offset) const;

 private:
  Reason whereEverythingIsTraced(const KnownMesh& mesh, const std::vector<MaterialChange>& materials) const;
  bool isOpaque(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;

  Parts p_;
};

}  // namespace gluray::gl
