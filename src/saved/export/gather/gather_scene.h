// A frame's batches as an exported scene. Any thread.
#pragma once
#include "saved/export/gather/exported_scene.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::saved {

/// Positions are in the world of the first batch of each view. The scene shares the arrays of the snapshots.
/// Throws std::bad_alloc.
ExportedScene gatherScene(const std::vector<scene::SnapshotPtr>& batches, const Abilities&);

}  // namespace gluray::saved
