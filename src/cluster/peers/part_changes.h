// Whether the parts of a view that ranks hold have moved against each other, or changed, since the moving
// frame before (scene::LightSampling::Mode::moving): then what light was there counts less. One thread at a
// time.
#pragma once
#include "render/moving/reprojection.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <list>
#include <vector>

namespace gluray::cluster {

/// What other ranks must know of a rank's surfaces in a view to notice that these move or change.
struct PartState {
  int rank = 0;
  uint64_t changes = 0;          // rises when its surfaces change, or move against each other
  glm::dmat4 eyeFromLargest{1};  // of the surface with most triangles; of others as this rank sees it
};

class PartChanges {
 public:
  /// This rank's surfaces in a view that begins; `frame` null: it has none. Throws std::bad_alloc.
  PartState show(const scene::Snapshot& snapshot, const render::FrameData* frame);
  /// Of the view that began last: whether anything is different since the last keep(). `parts`: this
  /// rank's, then those of the others that hold surfaces, in this rank's eye space.
  bool changed(std::vector<PartState> parts);
  /// The moving frame is whole.
  void keep() { view().kept = now_; }

 private:
  static constexpr size_t kMaxViews = 4;
  struct View {
    uint64_t name = 0;
    uint64_t number = 0;  // Snapshot::number of the last one; 0: none
    render::Placement placement;
    render::FilmSpace space;
    PartState own;
    std::vector<PartState> kept;
  };
  View& view() { return views_.front(); }
  void find(uint64_t name);

  std::list<View> views_;  // the one that began last first
  std::vector<PartState> now_;
  uint64_t changes_ = 0;
};

}  // namespace gluray::cluster
