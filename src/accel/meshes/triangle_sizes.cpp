#include "accel/meshes/triangle_sizes.h"

#include <glm/glm.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace gluray::accel {
namespace {

float longestSquared(const scene::Mesh& mesh, uint32_t triangle) {
  glm::vec3 p[3];
  for (uint32_t k = 0; k < 3; ++k) p[k] = mesh.position(mesh.corner(triangle, k));
  float squared = 0;
  for (int k = 0; k < 3; ++k) {
    const glm::vec3 edge = p[(k + 1) % 3] - p[k];
    squared = std::max(squared, glm::dot(edge, edge));  // max keeps the first if the second is NaN
  }
  return squared;
}

}  // namespace

float TriangleSizes::longestEdge(const scene::Mesh& mesh) {
  constexpr size_t kMaxKnown = 4096;
  if (mesh.shape != scene::Shape::triangles) return 0;
  if (mesh.residence) return mesh.residence->whole() ? mesh.residence->whole()->longestEdge : 0;
  const std::lock_guard lock(mutex_);
  const auto known = longest_.find(mesh.geometryId);
  if (known != longest_.end()) return known->second;
  if (longest_.size() >= kMaxKnown) longest_.clear();
  const float squared = tbb::parallel_reduce(
      tbb::blocked_range<uint32_t>(0, mesh.triangleCount, 4096), 0.0f,
      [&](const tbb::blocked_range<uint32_t>& range, float longest) {
        for (uint32_t t = range.begin(); t != range.end(); ++t)
          longest = std::max(longest, longestSquared(mesh, t));
        return longest;
      },
      [](float a, float b) { return std::max(a, b); });
  return longest_.emplace(mesh.geometryId, std::sqrt(squared)).first->second;
}

}  // namespace gluray::accel
