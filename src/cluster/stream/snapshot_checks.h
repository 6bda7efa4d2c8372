// Checks untrusted snapshots for the invariants of tracing. Any thread.
#pragma once
#include "scene/snapshot.h"

namespace gluray::cluster {

/// Throws Malformed if sizes or indices are inconsistent. Meshes, images and settings have been checked
/// before.
void check(const scene::Snapshot& snapshot);

}  // namespace gluray::cluster
