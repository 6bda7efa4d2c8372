// Whether a volume has what its samples are looked up in. Any thread.
#pragma once
#include "scene/volumes/volume.h"

namespace gluray::render {

/// Why a volume cannot be traced, whatever its voxels hold; null: it can.
const char* whyUntraceable(const scene::Volume& volume);

}  // namespace gluray::render
