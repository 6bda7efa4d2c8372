#include "gl/history/coincident_meshes.h"

#include "gl/capture/triangle_samples.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <vector>

namespace gluray::gl {
namespace {

struct CornerBounds {
  glm::vec3 lower{std::numeric_limits<float>::infinity()}, upper{-std::numeric_limits<float>::infinity()};
  void add(const glm::vec3& p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  bool contains(const glm::vec3& p) const {
    return glm::all(glm::greaterThanEqual(p, lower)) && glm::all(glm::lessThanEqual(p, upper));
  }
};

/// Equal for triangles of the same corners in the same order of rotation.
uint64_t keyOf(const Triangle& triangle) {
  std::array<uint64_t, 3> corners;
  for (size_t k = 0; k < 3; ++k) {
    const glm::vec3 position = triangle[k] + 0.0f;  // -0 is 0
    corners[k] = hashBytes(glm::value_ptr(position), sizeof position).low;
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return hashBytes(corners.data(), sizeof corners).low;
}

/// Whether a sampled triangle of `sampled` is a triangle of `all`.
bool holdsSome(const scene::Mesh& all, const scene::Mesh& sampled) {
  const CornerBounds bounds{all.lower, all.upper};
  std::unordered_set<uint64_t> keys;
  CornerBounds wanted;
  for (const Triangle& t : sampleTriangles(sampled)) {
    if (!std::all_of(t.begin(), t.end(), [&](const glm::vec3& p) { return bounds.contains(p); })) continue;
    keys.insert(keyOf(t));
    for (const glm::vec3& p : t) wanted.add(p);
  }
  if (keys.empty()) return false;
  for (uint32_t t = 0; t < all.triangleCount; ++t) {
    const glm::vec3 first = all.position(all.corner(t, 0));
    if (!wanted.contains(first)) continue;
    if (keys.contains(keyOf({first, all.position(all.corner(t, 1)), all.position(all.corner(t, 2))})))
      return true;
  }
  return false;
}

}  // namespace

bool CoincidentMeshes::coincide(const scene::Mesh& a, const scene::Mesh& b) {
  constexpr size_t kKept = 4096;
  if (a.geometryId == b.geometryId) return true;
  if (glm::any(glm::lessThan(a.upper, b.lower)) || glm::any(glm::lessThan(b.upper, a.lower))) return false;
  const Hash128 pair = hashBytes(&a.geometryId, sizeof a.geometryId, b.geometryId);
  if (const auto known = answers_.find(pair); known != answers_.end()) return known->second;
  if (answers_.size() >= kKept) answers_.clear();
  return answers_[pair] = holdsSome(a, b) || holdsSome(b, a);
}

}  // namespace gluray::gl
