// Snapshots of a view that the ranks of a sort-last program gather. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <memory>
#include <vector>

namespace gluray::cluster {

/// Adds the surfaces of `parts`, which other ranks draw into the same view, to `whole`: as if the program had
/// drawn them after its own, part by part. All have the same eye space. Throws Malformed where they are not
/// seen by one camera; `whole` is undefined then.
void merge(const std::vector<std::shared_ptr<scene::Snapshot>>& parts, scene::Snapshot& whole);

}  // namespace gluray::cluster
