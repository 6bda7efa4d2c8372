#include "bench/scale/parts.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace gluray::bench {
namespace {

TriangleMesh partOf(const TriangleMesh& mesh, const std::vector<uint32_t>& triangles, size_t begin,
                    size_t end) {
  TriangleMesh part;
  std::unordered_map<uint32_t, uint32_t> number;
  for (size_t t = begin; t < end; ++t)
    for (size_t corner = 0; corner < 3; ++corner) {
      const uint32_t vertex = mesh.indices[3 * size_t{triangles[t]} + corner];
      const auto [known, isNew] = number.try_emplace(vertex, static_cast<uint32_t>(part.positions.size()));
      if (isNew)
        part.positions.push_back(mesh.positions[vertex]), part.normals.push_back(mesh.normals[vertex]);
      part.indices.push_back(known->second);
    }
  part.positions.reserve(part.positions.size() + 1);
  return part;
}

}  // namespace

std::vector<TriangleMesh> slabs(const TriangleMesh& mesh, int parts) {
  std::vector<uint32_t> triangles(mesh.triangleCount());
  std::iota(triangles.begin(), triangles.end(), 0u);
  std::ranges::stable_sort(triangles, {},
                           [&](uint32_t t) { return mesh.positions[mesh.indices[3 * size_t{t}]].x; });
  std::vector<TriangleMesh> all;
  const auto count = static_cast<size_t>(parts);
  for (size_t i = 0; i < count; ++i)
    all.push_back(partOf(mesh, triangles, triangles.size() * i / count, triangles.size() * (i + 1) / count));
  return all;
}

}  // namespace gluray::bench
