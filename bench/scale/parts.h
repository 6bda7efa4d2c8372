// A mesh in parts, as the ranks of a sort-last program hold it.
#pragma once
#include "bench/data/triangle_mesh.h"

#include <vector>

namespace gluray::bench {

/// Slabs across the x axis, each with as many triangles, to one: by the first corner of each triangle. Every
/// part has the vertices that it needs and no others.
std::vector<TriangleMesh> slabs(const TriangleMesh& mesh, int parts);

}  // namespace gluray::bench
