// Isosurfaces of a volume as one indexed mesh. Used by the benchmarks and the demo; runs on all threads.
#pragma once
#include "bench/data/triangle_mesh.h"
#include "bench/data/volume.h"

#include <array>
#include <functional>
#include <vector>

namespace gluray::bench {

/// Progress callback, 0..1; called on whichever thread finished a part.
using Progress = std::function<void(double done)>;

/// The surfaces value = isovalue, one after the other in one mesh. Neighbouring triangles share their
/// vertices; inside is where the value is at or above the isovalue, and normals point outwards, down the
/// field's gradient (central differences, interpolated along the edge). The same volume gives the same mesh
/// on any number of threads. Throws std::runtime_error where the mesh needs more than 2^32 vertices. Source:
/// Lorensen and Cline, Marching Cubes, 1987; see cube_cases.h for what differs.
TriangleMesh isosurfaces(const Volume& volume, const std::vector<float>& isovalues,
                         const Progress& progress = {});

/// How large the mesh is that isosurfaces() makes.
struct MeshSize {
  size_t vertices = 0, triangles = 0;
};
MeshSize sizeOfIsosurfaces(const Volume& volume, const std::vector<float>& isovalues);

/// Fills one plane of a grid, z = `plane`: size[0] * size[1] values, x fastest. Called on all threads at
/// once.
using FillPlane = std::function<void(int plane, float* values)>;

/// The surface value = isovalue of a grid too large for memory, in units of its cells: point (x, y, z) lies
/// at (x, y, z). `thickness` layers of cells at a time are filled and meshed, the planes between them twice;
/// where two such slabs meet they have the same vertices and normals, each its own. Otherwise as above.
TriangleMesh isosurfaceInSlabs(const std::array<int, 3>& size, const FillPlane& fill, float isovalue,
                               int thickness = 64);

}  // namespace gluray::bench
