#include "accel/clusters.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gluray::accel {
namespace {

constexpr float kFarthest = 1.844e18f;  // Embree leaves out what lies beyond

struct Grown {
  glm::vec3 lower{INFINITY}, upper{-INFINITY};
  void join(const glm::vec3& p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  void join(const Grown& o) { lower = glm::min(lower, o.lower), upper = glm::max(upper, o.upper); }
  float halfArea() const {
    const glm::vec3 d = upper - lower;
    return d.x * (d.y + d.z) + d.y * d.z;
  }
};

/// False where some vertex is not to be traced.
bool boundsOf(const scene::Mesh& mesh, uint32_t triangle, Grown& box) {
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::vec3 p = mesh.position(mesh.corner(triangle, k));
    for (int c = 0; c < 3; ++c)
      if (!(std::abs(p[c]) < kFarthest)) return false;
    box.join(p);
  }
  return true;
}

/// Appends the first triangle of each cluster of [begin, end).
void cluster(const scene::Mesh& mesh, uint32_t begin, uint32_t end, std::vector<uint32_t>& first) {
  // A row of cells of a surface has about half the area that its triangles' boxes have in sum.
  constexpr float kLooser = 3;
  Grown box;
  float sum = 0;       // of the areas of their boxes
  uint32_t count = 0;  // triangles in it; 0: none that another may join
  for (uint32_t t = begin; t < end; ++t) {
    Grown own;
    const bool exists = boundsOf(mesh, t, own);
    if (exists && count > 0 && count < Clusters::kMost) {
      Grown both = box;
      both.join(own);
      if (both.halfArea() <= kLooser * (sum + own.halfArea())) {
        box = both;
        sum += own.halfArea();
        ++count;
        continue;
      }
    }
    first.push_back(t);
    box = own;
    sum = own.halfArea();
    count = exists ? 1 : 0;
  }
}

}  // namespace

Clusters::Clusters(const scene::Mesh& mesh) {
  mesh_.triangleCount = mesh.triangleCount, mesh_.vertexCount = mesh.vertexCount;
  mesh_.positions = mesh.positions, mesh_.indices = mesh.indices;
  constexpr uint32_t kBlock = 1 << 16;  // triangles
  const uint32_t blocks = (mesh.triangleCount + kBlock - 1) / kBlock;
  std::vector<std::vector<uint32_t>> parts(blocks);
  tbb::parallel_for(uint32_t{0}, blocks, [&](uint32_t b) {
    parts[b].reserve(kBlock / 4);
    const uint32_t begin = b * kBlock;
    cluster(mesh_, begin, begin + std::min(kBlock, mesh_.triangleCount - begin), parts[b]);
  });
  size_t total = 1;
  for (const auto& part : parts) total += part.size();
  first_.reserve(total);
  for (auto& part : parts) {
    first_.insert(first_.end(), part.begin(), part.end());
    part = {};
  }
  first_.push_back(mesh.triangleCount);
}

bool Clusters::pay() const { return uint64_t{count()} * 3 <= mesh_.triangleCount; }

Box Clusters::boxOf(uint32_t cluster) const {
  // Embree asks boxes of user geometry without the care that it takes with triangles: rays from as far away
  // as a hundred times the extent of a million such clusters must not slip by.
  constexpr float kOwn = 0x1p-6f, kPlace = 0x1p-20f;
  Grown box;
  for (uint32_t t = first(cluster); t < first(cluster + 1); ++t)
    if (!boundsOf(mesh_, t, box)) return {glm::vec3(1), glm::vec3(-1)};
  const glm::vec3 farthest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  const float margin =
      kOwn * glm::length(box.upper - box.lower) + kPlace * std::max({farthest.x, farthest.y, farthest.z});
  return {box.lower - margin, box.upper + margin};
}

}  // namespace gluray::accel
