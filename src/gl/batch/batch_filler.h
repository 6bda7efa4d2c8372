// Fills the batch: the one place where surfaces of the fixed-function pipeline and of shader programs become
// instances of it. A part of each Context, GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/capture/captured_vertices.h"
#include "gl/draws/triage.h"

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
    Flusher& flusher;
    Triage& triage;
    LayerDraws& layers;
  };
  explicit BatchFiller(const Parts& parts) : p_(parts) {}

  /// Adds a mesh with the fixed-function state of now. `materials` beside the current one.
  void add(const scene::MeshPtr& mesh, SlotMask slots, const std::vector<MaterialChange>& materials);

  /// Makes the batch one that takes a draw of that key: what waits under another is flushed first. False:
  /// nothing could be seen of the draw.
  bool open(const BatchKey& key);
  /// Cuts off what lies beyond the draw framebuffer.
  void clampToTarget(scene::Region& region);
  /// Another drawable may be behind the context now.
  void forgetDrawable() { drawableSize_ = {0, 0}; }
  /// After a draw was added: where a flush on the way failed, later draws are rasterised and must find this
  /// one drawn.
  void settleFailure() {
    if (p_.failsafe.aside()) p_.flusher.flush();
  }

 private:
  scene::Instance instanceOf(const scene::MeshPtr& mesh, SlotMask slots,
                             const std::vector<MaterialChange>& materials) const;
  scene::Shading shadingOf(SlotMask slots, const std::vector<MaterialChange>& materials) const;

  Parts p_;
  glm::ivec2 drawableSize_{0};  // largest size that the window is known to have had
  scene::Region sizeAskedFor_;
};

}  // namespace gluray::gl
