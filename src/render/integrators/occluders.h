// Which parts of surfaces block rays. Made once a frame, asked on all tracing threads.
#pragma once
#include "accel/occlusion.h"
#include "scene/snapshot.h"

#include <memory>

namespace gluray::render {

/// A filter that lets rays through what clip planes cut away; null where the snapshot, which must outlive it,
/// has none. Both sides of surfaces block, culled or not: what a program does not draw because it faces away
/// still belongs to a solid.
std::unique_ptr<const accel::OccluderFilter> makeOccluders(const scene::Snapshot&);

}  // namespace gluray::render
