// What the tiles of an image cost the rank that traces them: CPU time, measured on one thread.
#pragma once
#include "base/image.h"
#include "frame/tracing/renderer.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::bench {

/// Seconds of CPU time, medians over several tracings.
struct TileCosts {
  std::vector<double> tiles;  // of each tile
  double pack = 0;            // a tile's pixels into a message
  double begin = 0, end = 0;  // of an image, before its first and after its last tile
};

/// Traces the snapshot `rounds` times with one thread, once before without counting. `image`: the image.
/// Throws std::runtime_error.
TileCosts tileCosts(frame::Renderer& renderer, scene::Snapshot snapshot, int rounds, Image& image);

}  // namespace gluray::bench
