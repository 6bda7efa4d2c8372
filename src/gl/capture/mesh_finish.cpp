// What the arrays of a mesh tell: bounds, identity, opacity (mesh_builder.h).
#include "gl/capture/mesh_builder.h"
#include "parallel/loops.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gluray::gl {
namespace {

constexpr size_t kBoundsGrain = 1 << 16;  // vertices

struct Bounds {
  glm::vec3 lower{INFINITY}, upper{-INFINITY};
  void join(const Bounds& o) { lower = glm::min(lower, o.lower), upper = glm::max(upper, o.upper); }
};

Bounds boundsOf(const scene::Mesh& mesh) {
  return reducePieces(
      mesh.vertexCount, kBoundsGrain, Bounds{},
      [&](size_t first, size_t last, Bounds b) {
        for (size_t i = first; i < last; ++i) {
          const glm::vec3 p = mesh.position(static_cast<uint32_t>(i));
          if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) b.join({p, p});
        }
        return b;
      },
      [](Bounds a, const Bounds& b) {
        a.join(b);
        return a;
      });
}

/// Hash of the corners' positions in triangle order, computed in blocks on all cores. It does not depend on
/// which corners share vertices.
Hash128 geometryIdentity(const scene::Mesh& mesh) {
  constexpr uint32_t kTriangles = 1 << 14;
  const uint32_t blocks = (mesh.triangleCount + kTriangles - 1) / kTriangles;
  std::vector<Hash128> hashes(blocks);
  const auto hashBlock = [&](uint32_t b) {
    const uint32_t first = b * kTriangles, last = std::min(mesh.triangleCount, first + kTriangles);
    std::vector<glm::vec3> corners(size_t{last - first} * 3);
    glm::vec3* corner = corners.data();
    for (uint32_t t = first; t < last; ++t)
      for (uint32_t k = 0; k < 3; ++k) *corner++ = mesh.position(mesh.corner(t, k));
    hashes[b] = hashBytes(corners.data(), corners.size() * sizeof(glm::vec3));
  };
  forPieces(blocks, 1, [&](size_t b, size_t last) {
    for (; b < last; ++b) hashBlock(static_cast<uint32_t>(b));
  });
  return hashBytes(hashes.data(), hashes.size() * sizeof(Hash128), {mesh.triangleCount, 0});
}

bool allOpaque(const scene::Attribute& colors, uint32_t count) {
  if (!colors || colors.format == scene::Format::float3) return true;
  for (uint32_t i = 0; i < count; ++i)
    if (scene::fetch(colors, i).a != 1.0f) return false;
  return true;
}

}  // namespace

bool isFarAway(const scene::Mesh& mesh) {
  constexpr float kFarthest = 1e18f;
  const glm::vec3 reach = glm::max(glm::abs(mesh.lower), glm::abs(mesh.upper));
  return std::max({reach.x, reach.y, reach.z}) > kFarthest;
}

void finishMesh(scene::Mesh& mesh) {
  const Bounds bounds = boundsOf(mesh);
  if (bounds.lower.x <= bounds.upper.x) mesh.lower = bounds.lower, mesh.upper = bounds.upper;
  mesh.geometryId = geometryIdentity(mesh);
  mesh.opaqueColors = allOpaque(mesh.colors, mesh.vertexCount);
}

}  // namespace gluray::gl
