// Fills the batch: turns fixed-function surfaces into instances, and opens the batch for those of shader
// programs. A part of each Context, GL thread.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/classify/classifier.h"
#include "gl/flush/flusher.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::gl {

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
  };
  explicit BatchFiller(const Parts& parts) : p_(parts) {}

  /// Adds a mesh with the current fixed-function state, and the shader program in use, if there is one.
  /// `slots`: attributes that its vertices have. `materials`: those that its vertices select beside the
  /// current one.
  void add(const scene::MeshPtr& mesh, SlotMask slots, const std::vector<MaterialChange>& materials);

  /// Opens a batch for `key`, and flushes a pending one of another key, or of a world that has no place for
  /// `modelview`. False: the draw covers no pixel.
  bool open(const BatchKey& key, const glm::dmat4& modelview);
  /// Prepares a draw that gives one matrix, the product of all, and opens no batch yet: chooses a projection
  /// for `key`, that of the batch `there` if the rest is affine within `reach`, and flushes a pending batch
  /// that has another key, if `flushes`. Returns the rest, the modelview matrix. A batch has one projection,
  /// and projections that are factored out differ by rounding from draw to draw. `there`: null if there is
  /// none.
  glm::dmat4 factor(const glm::dmat4& clipFromObject, const glm::dvec3& reach, const BatchKey* there,
                    BatchKey& key, bool flushes = true);
  /// Clips the region to the draw framebuffer.
  void clampToTarget(scene::Region& region);
  /// The context may have another drawable now.
  void forgetDrawable() { drawableSize_ = {0, 0}; }
  /// Call after adding a draw. If a flush failed meanwhile, flushes the draw before later, rasterised ones.
  void settleFailure() {
    if (p_.failsafe.aside()) p_.flusher.flush();
  }

 private:
  scene::Instance instanceOf(const scene::MeshPtr& mesh, SlotMask slots,
                             const std::vector<MaterialChange>& materials) const;
  scene::Shading shadingOf(SlotMask slots, const std::vector<MaterialChange>& materials) const;

  /// Adds a surface of the shader program in use, which takes fixed function's vertices.
  void addByProgram(const BatchKey& key, const scene::MeshPtr& mesh, SlotMask slots);
  void addSolids(BatchKey key, const scene::MeshPtr& mesh, SlotMask slots,
                 const std::vector<MaterialChange>& materials);

  Parts p_;
  glm::ivec2 drawableSize_{0};  // largest known size of the window
  scene::Region sizeAskedFor_;
};

}  // namespace gluray::gl
