// Transparent surfaces that are summed without order (weighted blending, scene::Layers::Of::sums, adr/0016).
// Nothing is held back: the traced sums are added to those in the framebuffer, and rasterised draws may come
// before and after. A part of LayerDraws, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/batch/batch.h"
#include "gl/counts/draw_kinds.h"
#include "gl/layers/layer_parts.h"

namespace gluray::gl {

class SumDraws {
 public:
  explicit SumDraws(const LayerParts& parts) : p_(parts) {}

  /// Why a surface of the current shader program cannot be traced as such a layer, or Reason::traced.
  Reason classify(PrimitiveClass kind);
  /// As LayerDraws::start().
  bool start(const BatchKey& key, const glm::dmat4& modelview);

 private:
  LayerParts p_;
};

}  // namespace gluray::gl
