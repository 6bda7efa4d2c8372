// State of dual depth peeling. A program that peels first draws a depth pass, which finds each pixel's
// nearest and farthest depth, then peel after peel between them. We hold the depth pass back, trace all
// layers in place of the first peel, and leave nothing for later peels. Owned by LayerDraws, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/held_pass.h"
#include "scene/snapshot.h"

#include <algorithm>
#include <memory>

namespace gluray::gl {

struct Peeling {
  enum class Stage : uint8_t {
    none,
    depths,    // draws of the depth pass are held back
    surfaces,  // draws of the first peel are held back, too, or traced
    peels,     // traced, but not shown until we know how many peels the program draws
  };
  Stage stage = Stage::none;
  LayersTarget target;
  GLuint depthsFound = 0;  // texture that the depth pass writes and the first peel reads
  std::shared_ptr<const scene::Layers> layers;
  BatchKey tracedKey;
  scene::SnapshotPtr traced;  // what was traced so far; more surfaces may join

  // Stage::peels.
  LayerCounts counts;
  uint32_t peel = 1;     // number of the newest peel
  GLuint input = 0;      // texture that the newest peel reads depths from
  GLuint behind = 0;     // texture that peels write their farthest layers to
  bool blended = false;  // the newest peel's farthest layers were blended over earlier ones
  /// Number of peels after which the program last blended the remaining layers (0: never): the prediction for
  /// the next frame.
  uint32_t usual = 0;
  /// Depth texture of the remaining layers, of which none is left because all are shown; 0: none.
  GLuint emptied = 0;
  GLenum query = 0;  // target of the active query
  GLuint queryName = 0;

  /// Held draws had to be rasterised: hold nothing back for a while, longer each time.
  void failed() {
    wait_ = pause_ * std::max<size_t>(target.depths.draws.size(), 1);
    pause_ = std::clamp<size_t>(pause_ * 2, 1, kLongest);
  }
  void succeeded() { pause_ = 0; }
  /// Whether holding back may begin with this draw.
  bool mayBegin() {
    if (wait_ == 0) return true;
    --wait_;
    return false;
  }

 private:
  static constexpr size_t kLongest = 256;
  size_t pause_ = 0;  // length of the next pause, frames
  size_t wait_ = 0;   // draws left of this pause
};

}  // namespace gluray::gl
