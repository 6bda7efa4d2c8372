// Surfaces that are blended in drawing order (scene::Layers::Of::drawn, adr/0038), with blending on or
// without depth writes, drawn by fixed function or by shader programs that families describe. Colour and
// depth below them are read when the batch is presented. A part of LayerDraws, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/layers/layer_parts.h"

namespace gluray::gl {

class DrawnLayers {
 public:
  explicit DrawnLayers(const LayerParts& parts) : p_(parts) {}

  /// Whether surfaces that are not opaque, or write no depth, can now be traced as layers that are blended in
  /// drawing order.
  bool mayBeDrawn() const;
  /// Whether the real OpenGL draws such a surface of `triangles` triangles, because that is faster.
  bool leaves(uint64_t triangles);
  /// Sets the fields of `key` that such surfaces need.
  void describe(BatchKey& key, BatchKey::DrawnBy drawnBy) const;
  /// Call before such a batch is taken: reads the colour and depth below it. Returns false if they cannot be
  /// read.
  bool readUnder();

 private:
  /// The surfaces of a frame that could be blended in drawing order, traced or not.
  struct Drawn {
    uint64_t triangles = 0;
    uint64_t runs = 0;  // sequences of consecutive such draws with equal blending
  };

  LayerParts p_;
  Drawn drawn_, lastDrawn_;  // of this frame and of the previous one
  uint64_t frame_ = 0;       // frame number of drawn_
  uint64_t drawnLast_ = 0;   // number of the last such draw
  scene::Blending drawnBy_;
};

}  // namespace gluray::gl
