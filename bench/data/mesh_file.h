// Meshes in files that are read as fast as the disk gives them. Benchmarks only.
#pragma once
#include "bench/data/triangle_mesh.h"

#include <string>

namespace gluray::bench {

/// Writes 16 bytes "GLuRay mesh 1\n" and zeros, the numbers of vertices and of indices as 64 bits each, then
/// positions and normals (3 floats each) and indices (32 bits), all little-endian. A file of that name is
/// replaced only once all is written. Throws std::runtime_error with one clear line.
void writeMesh(const TriangleMesh& mesh, const std::string& path);
/// Reads what writeMesh() wrote. Throws std::runtime_error where the file is another kind or too short, or
/// if an index is beyond its vertices.
TriangleMesh readMesh(const std::string& path);

}  // namespace gluray::bench
