// The occlusion rays of an image as queries to one peer, before any are culled.
#pragma once
#include "frame/tracing/renderer.h"
#include "scene/snapshot.h"

#include <cstddef>

namespace gluray::bench {

struct AllQueries {
  size_t rays = 0, packets = 0, bytes = 0;
  size_t pixels = 0;  // that hit a surface
};

/// Traces the snapshot with one thread and writes every occlusion ray that it asks about with
/// cluster::QueryWriter, one for each tile, as a rank of a sort-last program does. Throws std::runtime_error.
AllQueries allQueries(frame::Renderer& renderer, scene::Snapshot snapshot);

}  // namespace gluray::bench
