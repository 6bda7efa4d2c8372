// Surfaces that are seen through, as programs composite them by dual depth peeling: a first pass finds the
// nearest and farthest depths, then peel after peel is drawn between them. We hold the first pass back, trace
// all layers in the place of the first peel and leave nothing to later ones. Owned by Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/programs/held_pass.h"
#include "scene/snapshot.h"

#include <algorithm>
#include <memory>

namespace gluray::gl {

struct Peeling {
  enum class Stage : uint8_t {
    none,
    depths,    // draws of the first pass are held back
    surfaces,  // and so are those of the first peel, or they have been traced
    peels,     // they are traced, but not shown before it is known how many peels the program draws
  };
  Stage stage = Stage::none;
  LayersTarget target;
  GLuint depthsFound = 0;  // texture that the first pass writes and the first peel reads
  std::shared_ptr<const scene::Layers> layers;
  BatchKey tracedKey;
  scene::SnapshotPtr traced;  // what the result shows already; more may join

  // Stage::peels.
  LayerCounts counts;
  uint32_t peel = 1;     // the newest
  GLuint input = 0;      // texture that it reads depths from
  GLuint behind = 0;     // texture that its farthest layers go to, and
  bool blended = false;  // whether they were put over those before
  /// After how many peels the program last blended what was left, 0 if never: probably it does again.
  uint32_t usual = 0;
  /// Texture of the depths between which such a draw finds nothing, all being shown; 0: none.
  GLuint emptied = 0;
  GLenum query = 0;  // that is active: its target
  GLuint queryName = 0;

  /// What was held back had to be drawn after all: for a while, and each time longer, nothing is.
  void failed() {
    wait_ = pause_ * std::max<size_t>(target.depths.draws.size(), 1);
    pause_ = std::clamp<size_t>(pause_ * 2, 1, kLongest);
  }
  void succeeded() { pause_ = 0; }
  /// Whether a draw may begin to be held back.
  bool mayBegin() {
    if (wait_ == 0) return true;
    --wait_;
    return false;
  }

 private:
  static constexpr size_t kLongest = 256;
  size_t pause_ = 0;  // frames
  size_t wait_ = 0;   // draws
};

}  // namespace gluray::gl
