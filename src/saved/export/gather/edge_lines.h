// Painted edges of triangles (scene::FragmentShading::edges) as lines. Any thread.
#pragma once
#include "saved/export/arrays/array_source.h"
#include "scene/snapshot.h"

namespace gluray::saved {

/// Indices of the ends of the edges that the instance paints, each edge once; null if it paints none.
SourcePtr edgeIndices(const scene::Instance&);

}  // namespace gluray::saved
