// State of dual depth peeling. A program that peels first draws a depth pass, which finds each pixel's
// nearest and farthest depth, then peel after peel between these. GLuRay holds the depth pass back, traces
// all layers in place of the first peel, and leaves nothing for later peels. Owned by HeldPeels, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/held_pass.h"
#include "gl/layers/peel_pauses.h"
#include "scene/snapshot.h"

#include <memory>

namespace gluray::gl {

struct Peeling {
  enum class Stage : uint8_t {
    none,
    depths,    // draws of the depth pass are held back
    surfaces,  // draws of the first peel are held back, too, or traced
    peels,     // traced, but not shown until the number of the program's peels is known
  };
  Stage stage = Stage::none;
  LayersTarget target;
  GLuint depthsFound = 0;  // texture that the depth pass writes and the first peel reads
  std::shared_ptr<const scene::Layers> layers;
  BatchKey tracedKey;
  scene::SnapshotPtr traced;  // the surfaces traced so far; more may join

  // Used in Stage::peels.
  LayerCounts counts;
  uint32_t peel = 1;     // number of the newest peel
  GLuint input = 0;      // texture from which the newest peel reads depths
  GLuint behind = 0;     // texture to which peels write their farthest layers
  bool blended = false;  // the newest peel's farthest layers were blended over earlier ones
  /// Number of peels after which the program last blended the remaining layers (0: never). It predicts the
  /// number in the next frame.
  uint32_t usual = 0;
  /// Depth texture of the remaining layers, if none remain because all are shown; else 0.
  GLuint emptied = 0;
  GLenum query = 0;  // target of the active query
  GLuint queryName = 0;

  PeelPauses pauses;
  PeelPauses::Pass pass;  // the depth pass that is held back
};

}  // namespace gluray::gl
