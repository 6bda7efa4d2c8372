// Surfaces drawn by shader programs: decides whether they can be traced, and adds them to the batch. A part
// of each Context, GL thread.
#pragma once
#include "gl/arrays/array_indices.h"
#include "gl/basics/reasons.h"
#include "gl/capture/mesh_cache.h"
#include "gl/counts/draw_kinds.h"
#include "gl/draws/batch_filler.h"
#include "gl/draws/raster_draws.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <map>
#include <memory>
#include <optional>

namespace gluray::gl {

class ProgramDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    SurfaceHistory& surfaces;
    PendingBatch& pending;
    Flusher& flusher;
    Classifier& classifier;
    BatchFiller& filler;
    RasterDraws& raster;
    LayerDraws& layers;
  };
  explicit ProgramDraws(const Parts& parts) : p_(parts) {}

  /// The reason why a surface of the current shader program cannot be traced now, or Reason::traced. `load`:
  /// number of triangles that the real OpenGL would draw.
  Reason classify(PrimitiveClass kind);
  Reason classify(const KnownMesh& mesh, uint64_t load);
  /// The reason from further conditions on impostors, or Reason::traced.
  Reason classifyImpostors();
  /// The reason from further conditions on the instances of a draw, or Reason::traced.
  Reason classifyInstances(const scene::Mesh& mesh, const Elements& elements) const;
  /// Adds a mesh to the batch, once for each instance of the draw. Returns Reason::traced, or why it cannot
  /// join the layers traced so far.
  Reason add(const scene::MeshPtr& mesh, GLenum mode, const Elements& elements);
  /// Call before a surface is rasterised: makes the real OpenGL draw the depth of pending or traced surfaces
  /// with which it coincides.
  void meetPasses(PrimitiveClass kind, GLenum mode, const Elements& elements);

 private:
  Reason readCoordinateShift();
  Reason classifyAlways(const KnownMesh& mesh) const;  // as if engine = always
  /// The reason why a surface is not traced because of its alpha, blending or depth mask, or Reason::traced.
  Reason ofBlending(const scene::Mesh& mesh) const;
  /// Why a coarse depth buffer keeps an opaque surface from being traced, or Reason::traced: hits of one
  /// depth step are not compared with those that rays find behind failing fragments, or at grown edges.
  Reason ofCoarseDepth() const;
  /// Whether surfaces can now be blended in drawing order.
  bool mayBeBlended() const;
  /// Whether this surface would be blended in drawing order.
  bool isBlended(const scene::Mesh& mesh) const;
  /// The reason why a surface with an alpha below 1 is not traced, or Reason::traced. Considers instances.
  Reason unlessOpaque() const;
  /// Whether highlights are elsewhere where directions to the viewer are those of the pixels.
  bool movesHighlights(const scene::Mesh& mesh) const;
  bool isOneOfPasses(const scene::Mesh& mesh) const;
  /// A sample of triangles from each array that may hold positions.
  std::vector<std::vector<Triangle>> sampleArrays(GLenum mode, const Elements& elements) const;
  enum class Placed { nowhere, inBatch, otherCamera };
  Placed preparePlace(const scene::Mesh& mesh, const glm::dvec3& reach, glm::dmat4& modelview);
  glm::dvec3 reachOfInstances(const scene::Mesh& mesh, const Elements& elements) const;
  void addInstancesOf(const scene::Instance& one, const scene::Shading& shading, const Elements& elements);
  Parts p_;
  std::map<int, std::optional<glm::vec2>> coordinateShifts_;  // by number of samples, of those tried out
};

}  // namespace gluray::gl
