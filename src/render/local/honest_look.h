// The program's colours without light (setting look = honest). Made once a frame on the calling thread.
#pragma once
#include "render/local/surface.h"

#include <vector>

namespace gluray::render {

/// Altered shadings and materials for which the local look yields the program's surface colours: diffuse
/// material, vertex colours or colour map, times textures, without light, highlight or fog. The material does
/// not tint colours of a map or of vertices, so pixels match the program's colour bar exactly.
class HonestLook {
 public:
  /// `snapshot` must outlive it.
  explicit HonestLook(const scene::Snapshot& snapshot);
  const std::vector<scene::Shading>& shadings() const { return shadings_; }
  /// Sets the materials of a surface that was made with one of shadings(). May run in parallel for different
  /// instances.
  void apply(size_t instance, Surface&);

 private:
  std::vector<scene::Shading> shadings_;
  std::vector<std::vector<scene::MaterialPair>> materials_;
};

}  // namespace gluray::render
