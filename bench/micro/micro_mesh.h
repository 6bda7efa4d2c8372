// The mesh of the micro benchmarks: isosurfaces of the Wavelet, 0.87 million triangles, and as sent by
// glBegin.
#pragma once
#include "bench/data/isosurface.h"
#include "bench/data/wavelet.h"

#include <vector>

namespace gluray::bench {

inline const TriangleMesh& microMesh() {
  static const TriangleMesh mesh = [] {
    const Volume volume = wavelet();
    const auto [low, high] = volume.range();
    return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(1)));
  }();
  return mesh;
}

/// Normal and position of every corner of the first `triangles`, one after the other: the input of a program
/// that sends triangles.
inline std::vector<Vertex> corners(size_t triangles) {
  const TriangleMesh& mesh = microMesh();
  std::vector<Vertex> out;
  out.reserve(6 * triangles);
  for (size_t i = 0; i < 3 * triangles; ++i) {
    out.push_back(mesh.normals[mesh.indices[i]]);
    out.push_back(mesh.positions[mesh.indices[i]]);
  }
  return out;
}

inline constexpr size_t kMicroTriangles = 300'000;  // sent by glBegin; 0.9 million vertices, two calls each

}  // namespace gluray::bench
