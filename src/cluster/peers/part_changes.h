// Detects whether the ranks' parts of a view have moved relative to each other, or changed, since the
// previous moving frame (scene::LightSampling::Mode::moving), so that the light history gets less weight. One
// thread at a time.
#pragma once
#include "render/moving/reprojection.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <list>
#include <vector>

namespace gluray::cluster {

/// State of a rank's surfaces in a view, from which other ranks detect motion and changes.
struct PartState {
  int rank = 0;
  uint64_t changes = 0;          // increases when its surfaces change, or move relative to each other
  glm::dmat4 eyeFromLargest{1};  // of the surface with most triangles; of others as this rank sees it
};

class PartChanges {
 public:
  /// Begins a view with this rank's surfaces; `frame` null: none. Throws std::bad_alloc.
  PartState show(const scene::Snapshot& snapshot, const render::FrameData* frame);
  /// Whether the current view has changed since the last keep(). `parts`: the state of this rank, followed by
  /// those of other ranks with surfaces, in this rank's eye space.
  bool changed(std::vector<PartState> parts);
  /// The moving frame is complete.
  void keep() { view().kept = now_; }

 private:
  static constexpr size_t kMaxViews = 4;
  struct View {
    uint64_t name = 0;
    uint64_t number = 0;  // Snapshot::number of the last one; 0: none
    render::Placement placement;
    render::PixelSpace space;
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
