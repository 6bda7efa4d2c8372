// Fills the batch: converts fixed-function surfaces to instances, and opens the batch for surfaces of shader
// programs. A part of each Context, GL thread.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/classify/classifier.h"
#include "gl/flush/flusher.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::gl {

class RasterDraws;

class BatchFiller {
 public:
  struct Parts {
    ShadowState& shadow;
    const Failsafe& failsafe;
    FrameClock& clock;
    SurfaceHistory& surfaces;
    PendingBatch& pending;
    Flusher& flusher;
    Classifier& classifier;
    LayerDraws& layers;
    RasterDraws& raster;
  };
  explicit BatchFiller(const Parts& parts) : p_(parts) {}

  /// Adds a mesh with the current fixed-function state, and the shader program in use, if there is one.
  /// `slots`: attributes that its vertices have. `materials`: the materials that its vertices select, in
  /// addition to the current one.
  void add(const scene::MeshPtr& mesh, SlotMask slots, const std::vector<MaterialChange>& materials);

  /// Opens a batch for `key`. First flushes a pending batch that has another key, or whose world space cannot
  /// contain `modelview`. Returns false if the draw covers no pixel.
  bool open(const BatchKey& key, const glm::dmat4& modelview);
  /// Factors the single matrix of a draw into projection and modelview matrix, without opening a batch.
  /// Chooses the projection for `key`: that of the batch `there` if the remaining matrix is then affine
  /// within `reach`. A batch has one projection, and projections that are factored out differ by rounding
  /// from draw to draw. If `flushes`, flushes a pending batch that has another key. `there`: null if there is
  /// none. Returns the modelview matrix.
  glm::dmat4 factor(const glm::dmat4& clipFromObject, const glm::dvec3& reach, const BatchKey* there,
                    BatchKey& key, bool flushes = true);
  /// Clips the region to the draw framebuffer.
  void clampToTarget(scene::Region& region);
  /// Reports that the context may have another drawable now.
  void forgetDrawable() { drawableSize_ = {0, 0}; }
  /// Call after a surface was added that tests depth: reports it to MultipassSurfaces, if it `leavesDepth`.
  /// If it coincides with traced surfaces of earlier batches, the real OpenGL draws it, the pending batch,
  /// and their depth.
  void reportDrawn(const scene::MeshPtr& mesh, const glm::dmat4& modelview, bool leavesDepth);
  /// The same for a surface that a shader program places by `clipFromObject`.
  void reportDrawnByProgram(const scene::MeshPtr& mesh, const glm::dmat4& modelview,
                            const glm::dmat4& clipFromObject, bool leavesDepth);
  /// Call after a draw was added: if a flush failed meanwhile, flushes the draw before later, rasterised
  /// ones.
  void settleFailure() {
    if (p_.failsafe.aside()) p_.flusher.flush();
  }

 private:
  scene::Instance instanceOf(const scene::MeshPtr& mesh, SlotMask slots,
                             const std::vector<MaterialChange>& materials) const;
  scene::Shading shadingOf(SlotMask slots) const;
  /// Whether the material of a surface whose vertices have these attributes does not follow the colour.
  bool ignoresColor(SlotMask slots) const;

  /// Adds a surface of the shader program in use, which reads fixed function's vertices.
  void addByProgram(const BatchKey& key, const scene::MeshPtr& mesh, SlotMask slots);
  void addSolids(BatchKey key, const scene::MeshPtr& mesh, SlotMask slots,
                 const std::vector<MaterialChange>& materials);

  Parts p_;
  glm::ivec2 drawableSize_{0};  // largest known size of the window
  scene::Region sizeAskedFor_;
};

}  // namespace gluray::gl
