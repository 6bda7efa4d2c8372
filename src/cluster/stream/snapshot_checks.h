// What tracing relies on in snapshots that come from elsewhere. Any thread.
#pragma once
#include "scene/snapshot.h"

namespace gluray::cluster {

/// Throws Malformed where sizes and indices do not fit each other. Meshes, images and settings have been
/// checked before.
void check(const scene::Snapshot& snapshot);

}  // namespace gluray::cluster
