// Decides whether draws of the fixed-function pipeline are traced or rasterised, and contains the checks that
// all draws share. A part of each Context, GL thread.
#pragma once
#include "gl/basics/affine.h"
#include "gl/basics/failsafe.h"
#include "gl/basics/reasons.h"
#include "gl/capture/mesh_cache.h"
#include "gl/clock/frame_clock.h"
#include "gl/counts/draw_kinds.h"
#include "gl/history/surface_history.h"
#include "gl/pending/pending_batch.h"
#include "gl/shadow/shadow_state.h"

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

namespace gluray::gl {

class LayerDraws;

class Classifier {
 public:
  struct Parts {
    ShadowState& shadow;
    const Failsafe& failsafe;
    FrameClock& clock;
    SurfaceHistory& surfaces;
    PendingBatch& pending;
    LayerDraws& layers;
  };
  explicit Classifier(const Parts& parts) : p_(parts) {}

  /// The reason why no draw, of fixed function or a program, can be traced now (failure, query, framebuffer),
  /// or Reason::traced.
  Reason ofContext() const;
  /// Reason::noGlsl if this OpenGL cannot show traced images, else Reason::traced. A mixed frame delays the
  /// check to draws that are too large for the real OpenGL: call it again for these, with `large`.
  Reason ofImages(bool large) const;
  /// Why GL_GREATER, GL_GEQUAL or clip depths from 0 prevent tracing: all depths are equal, the program moves
  /// them, or it draws impostors.
  Reason ofDepths() const;
  /// Whether the depth range makes all depths equal, so that drawing order decides between opaque surfaces.
  bool hasNoDepth() const {
    const ViewportState& viewport = p_.shadow.viewport();
    return viewport.depthNear == viewport.depthFar;
  }
  /// Whether the depth buffer is so coarse that surfaces behind each other may have equal depths there.
  bool hasCoarseDepth() const { return p_.shadow.target().coarseDepthSteps() > 0; }
  /// Whether the mesh lies within two steps of a coarse depth buffer, where OpenGL's rounding decides what it
  /// hides.
  bool isThin(const scene::Mesh& mesh, const glm::dmat4& clipFromObject) const {
    const ViewportState& viewport = p_.shadow.viewport();
    const double range = std::abs(double{viewport.depthFar} - double{viewport.depthNear});
    const double steps = 0.5 * range * p_.shadow.target().coarseDepthSteps();
    return hasCoarseDepth() && steps * depthExtent(mesh, clipFromObject) < 2;
  }
  /// The reason why a draw of fixed function's vertices, by fixed function or by a shader program, cannot be
  /// traced now if it has this primitive class, or Reason::traced.
  Reason classify(PrimitiveClass kind) const;
  /// The same for a surface with this mesh. Call after classify(kind).
  Reason classify(const KnownMesh& mesh, const std::vector<MaterialChange>& materials);
  /// Whether a surface that can be traced is a layer that is blended in drawing order
  /// (DrawnLayers::mayBeDrawn()).
  bool isLayer(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;

  /// Whether draws of this class are surfaces with a depth test against the framebuffer.
  bool meetsDepth(PrimitiveClass kind) const;
  /// Whether such draws leave depths against which later draws are tested.
  bool leavesDepth(PrimitiveClass kind) const;
  /// Whether surfaces are now drawn with a polygon offset away from the viewer.
  bool isPushedBack() const;
  /// Whether surfaces are now drawn with a polygon offset that increases depths, whatever the depth function.
  bool increasesDepth() const;
  /// Whether isPushedBack() would be true for filled faces where one face, or both, are not filled.
  bool fillsArePushedBack() const;
  /// The place of a mesh that is drawn now with this matrix and polygon offset.
  SurfacePlace placeOf(const glm::dmat4& clipFromObject, scene::PolygonOffset offset) const;

 private:
  Reason ofProgram() const;
  bool isOpaqueByProgram(const scene::Mesh& mesh) const;
  Reason ofProgramsMesh(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;
  Reason whereEverythingIsTraced(const KnownMesh& mesh, const std::vector<MaterialChange>& materials) const;
  Reason ofSolids(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;
  bool isOpaque(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;

  Parts p_;
};

}  // namespace gluray::gl
