// The program's colours without light (setting look = honest). Made once a frame on the calling thread.
#pragma once
#include "render/local/surface.h"

#include <vector>

namespace gluray::render {

/// Shadings and materials with which the local look yields the colours that programs give to surfaces:
/// diffuse material, vertex colours or colour map, times textures; no light, highlight or fog. Where colours
/// come from a map or from vertices, the material does not tint them. So pixels have exactly the colours of
/// the program's colour bar.
class HonestLook {
 public:
  /// `snapshot` must outlive it.
  explicit HonestLook(const scene::Snapshot& snapshot);
  const std::vector<scene::Shading>& shadings() const { return shadings_; }
  /// Gives a surface, made with one of shadings(), its materials. Different instances in parallel.
  void apply(size_t instance, Surface&);

 private:
  std::vector<scene::Shading> shadings_;
  std::vector<std::vector<scene::MaterialPair>> materials_;
};

}  // namespace gluray::render
