// Merges the snapshots of a view from the ranks of a sort-last program. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <memory>
#include <vector>

namespace gluray::cluster {

/// Appends the surfaces of `parts`, the other ranks' snapshots of the same view, to `whole`, in order. All
/// have the same eye space. Throws Malformed if their cameras differ; `whole` is then undefined.
void merge(const std::vector<std::shared_ptr<scene::Snapshot>>& parts, scene::Snapshot& whole);

}  // namespace gluray::cluster
