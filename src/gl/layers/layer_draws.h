// Draws of transparent surfaces (layers): peeled in depth order, summed without order or blended in drawing
// order. Each kind has a class, which decides whether the surfaces can be traced. A part of each Context, GL
// thread.
#pragma once
#include "gl/layers/drawn_layers.h"
#include "gl/layers/held_peels.h"
#include "gl/layers/later_peels.h"
#include "gl/layers/layer_parts.h"
#include "gl/layers/layer_programs.h"
#include "gl/layers/peel_draws.h"
#include "gl/layers/sum_draws.h"

namespace gluray::gl {

class LayerDraws {
 public:
  explicit LayerDraws(const LayerParts& parts)
      : drawn(parts), sums(parts), held(parts), later(parts, held), peels(parts, held, later) {}

  DrawnLayers drawn;
  SumDraws sums;
  HeldPeels held;  // what peeling holds back
  LaterPeels later;
  PeelDraws peels;

  /// Begins a batch of peeled or summed layers, whose first surface has this modelview matrix, or reopens the
  /// pending or traced one. Returns false if it has another key, or no depth can be read.
  bool start(const BatchKey& key, const glm::dmat4& modelview) {
    return key.layers == BatchKey::Layers::peeled ? peels.start(key, modelview) : sums.start(key, modelview);
  }
};

}  // namespace gluray::gl
