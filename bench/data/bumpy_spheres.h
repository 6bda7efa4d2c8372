// Nested spheres with bumps: many surfaces behind each other, of which the outermost alone is seen.
#pragma once
#include "bench/data/triangle_mesh.h"

namespace gluray::bench {

/// `count` closed surfaces around the origin, one inside the other, of about `triangles` triangles together,
/// as many in each; the outermost reaches to kDataReach (orbit.h). The radius of each swells and shrinks by
/// 4 % along waves in latitude and longitude. Outermost last: each is drawn over what lies within it.
/// The same arguments give the same mesh. Throws std::invalid_argument where count < 1.
TriangleMesh bumpySpheres(int count, double triangles);

}  // namespace gluray::bench
