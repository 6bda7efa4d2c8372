// Detects that a view holds other surfaces than its batches were lit with. Used by ViewScenes, GL thread.
#pragma once
#include "gl/views/scene_extents.h"
#include "gl/views/view_epoch.h"
#include "scene/secondary_scene.h"

namespace gluray::gl {

/// Whether light sees no difference between two secondary scenes of equal snapshots: equal surfaces, at
/// places that are equal but for rounding. Null: an empty one. Ignores the lights of surfaces, which programs
/// place in eye space: those of an earlier frame differ wherever the camera has moved.
bool lightAlike(const scene::SecondaryScene* a, const scene::SecondaryScene* b);

/// The snapshot of one of the epoch's batches without erased surfaces, and with all others as its secondary
/// scene; the one that it has where light sees no difference. Throws std::bad_alloc.
scene::SnapshotPtr relitOf(const ViewEpoch& epoch, size_t batch, const SceneExtents& extents);

/// A clear has removed what the epoch's batches have drawn in `box`: marks the surfaces that lay in it as a
/// whole. Throws std::bad_alloc.
void eraseSurfaces(ViewEpoch& epoch, const scene::Region& box);

}  // namespace gluray::gl
