#include "gl/history/ray_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gluray::gl {
namespace {

constexpr double kRounding = 0x1p-24;  // relative rounding error of a float
constexpr double kMaxPixels = 0.1;

glm::dvec3 rowOf(const glm::dmat4& m, int row) { return {m[0][row], m[1][row], m[2][row]}; }

/// Upper bound of the pixels that an object-space distance of 1 covers in the viewport where clip w is 1.
double pixelsAtOne(const glm::dmat4& clipFromObject, glm::ivec2 viewport) {
  const auto length = [&](int row) { return glm::length(rowOf(clipFromObject, row)); };
  const double w = length(3);
  return 0.5 * std::max((length(0) + w) * viewport.x, (length(1) + w) * viewport.y);
}

/// Clip w of the nearest point of the view volume; 0 if unknown. 1/w is linear in normalised device
/// coordinates (last row of the inverse matrix), so a corner has the largest.
double nearestViewW(const glm::dmat4& clipFromObject) {
  const glm::dmat4 inverse = glm::inverse(clipFromObject);
  const double most =
      std::abs(inverse[0][3]) + std::abs(inverse[1][3]) + std::abs(inverse[2][3]) + inverse[3][3];
  return most > 0 && std::isfinite(most) ? 1 / most : 0;
}

struct Box {
  glm::dvec3 middle, half;
};

/// Lower bound of clip w of the box's visible points; 0 if unknown.
double nearestW(const Box& box, const glm::dmat4& clipFromObject) {
  const glm::dvec3 row = rowOf(clipFromObject, 3);
  const double middle = glm::dot(row, box.middle) + clipFromObject[3][3];
  return std::max(middle - glm::dot(glm::abs(row), box.half), nearestViewW(clipFromObject));
}

Box boxOf(const scene::Mesh& mesh) {
  const glm::dvec3 lower(mesh.lower), upper(mesh.upper);
  return {0.5 * (lower + upper), 0.5 * (upper - lower)};
}

Box placed(const Box& box, const glm::dmat4& matrix) {
  Box result{glm::dvec3(matrix * glm::dvec4(box.middle, 1)), glm::dvec3(0)};
  for (int c = 0; c < 3; ++c) result.half += glm::abs(glm::dvec3(matrix[c])) * box.half[c];
  return result;
}

/// A triangle that is clipped by six planes, each of which adds at most one corner.
struct Polygon {
  std::array<glm::dvec4, 9> corners;
  size_t size = 0;
  void add(const glm::dvec4& p) {
    if (size < corners.size()) corners[size++] = p;  // only rounding errors can produce more
  }
};

/// Smallest clip w of the part of a triangle inside the view volume; infinite if there is none.
double nearestSeenW(const std::array<glm::dvec4, 3>& triangle) {
  Polygon polygon;
  for (const glm::dvec4& p : triangle) polygon.add(p);
  for (int plane = 0; plane < 6 && polygon.size > 0; ++plane) {
    const auto inside = [&](const glm::dvec4& p) { return p.w + (plane & 1 ? -1 : 1) * p[plane / 2]; };
    Polygon kept;
    for (size_t i = 0; i < polygon.size; ++i) {
      const glm::dvec4 &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.size];
      const double da = inside(a), db = inside(b);
      if (da >= 0) kept.add(a);
      if ((da < 0) != (db < 0)) kept.add(glm::mix(a, b, da / (da - db)));
    }
    polygon = kept;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < polygon.size; ++i) nearest = std::min(nearest, polygon.corners[i].w);
  return nearest;
}

/// Whether ray-triangle tests of the mesh leave the range of floats: they multiply three distances.
bool isBeyondFloats(const scene::Mesh& mesh) {
  constexpr double kLargest = 1e11, kSmallest = 1e-12;
  const glm::dvec3 lower(mesh.lower), upper(mesh.upper), reach = glm::max(glm::abs(lower), glm::abs(upper));
  const double most = std::max({reach.x, reach.y, reach.z}), size = glm::length(upper - lower);
  return std::isfinite(most) && (most > kLargest || (size > 0 && size < kSmallest));
}

}  // namespace

bool RayPrecision::isFarFromOrigin(const scene::Mesh& mesh, const glm::dmat4& clipFromObject,
                                   glm::ivec2 viewport, const glm::dmat4& objectFromMesh) {
  constexpr double kFar = 8;  // half diagonals
  const Box box = placed(boxOf(mesh), objectFromMesh);
  if (!(glm::length(box.middle) > kFar * glm::length(box.half))) return false;
  // A clip coordinate is a sum of products, and each product is rounded.
  const auto summed = [&](int row) {
    return glm::dot(glm::abs(rowOf(clipFromObject, row)), glm::abs(box.middle)) +
           std::abs(clipFromObject[3][row]);
  };
  const double w = summed(3);
  const double rounded = 0.5 * std::max((summed(0) + w) * viewport.x, (summed(1) + w) * viewport.y);
  return !(kRounding * rounded < kMaxPixels * nearestW(box, clipFromObject));
}

bool RayPrecision::isTooLarge(const scene::Mesh& mesh, const glm::dmat4& clipFromObject,
                              glm::ivec2 viewport) {
  if (mesh.shape != scene::Shape::triangles || mesh.triangleCount == 0) return false;
  if (isBeyondFloats(mesh)) return true;
  const double perSize = kRounding * pixelsAtOne(clipFromObject, viewport);  // error in pixels where w is 1
  const auto tooLarge = [&](double size, double w) { return !(perSize * size < kMaxPixels * w); };
  const double least = nearestW(boxOf(mesh), clipFromObject);
  if (!tooLarge(glm::length(glm::dvec3(mesh.upper) - glm::dvec3(mesh.lower)), least)) return false;
  for (const Large& large : largestOf(mesh)) {
    if (!tooLarge(large.size, least)) return false;  // the remaining ones are smaller
    std::array<glm::dvec4, 3> corners;
    for (uint32_t k = 0; k < 3; ++k)
      corners[k] = clipFromObject * glm::dvec4(mesh.position(mesh.corner(large.triangle, k)), 1);
    const double nearest = nearestSeenW(corners);
    if (std::isfinite(nearest) && tooLarge(large.size, nearest)) return true;
  }
  return false;
}

const std::vector<RayPrecision::Large>& RayPrecision::largestOf(const scene::Mesh& mesh) {
  constexpr size_t kMaxKnown = 4096;
  if (largest_.size() > kMaxKnown) largest_.clear();
  const auto known = largest_.find(mesh.geometryId);
  if (known != largest_.end()) return known->second;
  const auto larger = [](const Large& a, const Large& b) { return a.size > b.size; };
  const auto squared = [](const glm::vec3& edge) {
    const glm::dvec3 e(edge);
    return glm::dot(e, e);
  };
  std::vector<Large> all;  // min-heap by size; sizes are squared until the end
  for (uint32_t t = 0; t < mesh.triangleCount; ++t) {
    const glm::vec3 a = mesh.position(mesh.corner(t, 0)), b = mesh.position(mesh.corner(t, 1)),
                    c = mesh.position(mesh.corner(t, 2));
    const double size = std::max({0.0, squared(b - a), squared(c - b), squared(a - c)});
    if (all.size() == kMaxExamined && size <= all.front().size) continue;
    if (all.size() == kMaxExamined) std::pop_heap(all.begin(), all.end(), larger), all.pop_back();
    all.push_back({t, size});
    std::push_heap(all.begin(), all.end(), larger);
  }
  std::sort(all.begin(), all.end(), larger);
  for (Large& large : all) large.size = std::sqrt(large.size);
  return largest_.emplace(mesh.geometryId, std::move(all)).first->second;
}

}  // namespace gluray::gl
