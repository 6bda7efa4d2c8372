#include "gl/sheets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::gl {
namespace {

constexpr double kNarrow = 1e-5;  // NDC; what overlaps by less covers no sample that anybody would miss

glm::dvec3 position(const scene::Mesh& mesh, uint32_t triangle, uint32_t k) {
  return glm::dvec3(mesh.position(mesh.corner(triangle, k)));
}

/// The plane that all corners lie in but for roundings of their coordinates.
std::optional<glm::dvec4> findPlane(const scene::Mesh& mesh) {
  glm::dvec3 normal(0);
  for (uint32_t t = 0; t < mesh.triangleCount && normal == glm::dvec3(0); ++t) {
    const glm::dvec3 p = position(mesh, t, 0);
    normal = glm::cross(position(mesh, t, 1) - p, position(mesh, t, 2) - p);
  }
  if (!(glm::length(normal) > 0)) return std::nullopt;
  normal = glm::normalize(normal);
  const glm::dvec3 origin = position(mesh, 0, 0);
  const glm::dvec3 reach = glm::max(glm::abs(glm::dvec3(mesh.lower)), glm::abs(glm::dvec3(mesh.upper)));
  const double rounding = 1e-6 * (reach.x + reach.y + reach.z);
  for (uint32_t t = 0; t < mesh.triangleCount; ++t)
    for (uint32_t k = 0; k < 3; ++k)
      if (!(std::abs(glm::dot(normal, position(mesh, t, k) - origin)) <= rounding)) return std::nullopt;
  return glm::dvec4(normal, -glm::dot(normal, origin));
}

using Corners2 = std::array<glm::dvec2, 3>;

/// Whether some edge of `a` has all of `b` beyond it.
bool isApart(const Corners2& a, const Corners2& b) {
  for (size_t k = 0; k < 3; ++k) {
    const glm::dvec2 edge = a[(k + 1) % 3] - a[k];
    const double length = glm::length(edge);
    if (!(length > 0)) return true;
    const glm::dvec2 normal = glm::dvec2(-edge.y, edge.x) / length;
    const double side = glm::dot(normal, a[(k + 2) % 3] - a[k]) < 0 ? -1 : 1;
    const auto inward = [&](const glm::dvec2& p) { return side * glm::dot(normal, p - a[k]); };
    if (std::max({inward(b[0]), inward(b[1]), inward(b[2])}) <= kNarrow) return true;
  }
  return false;
}

Corners2 flat(const std::array<glm::dvec3, 3>& t) {
  return {glm::dvec2(t[0]), glm::dvec2(t[1]), glm::dvec2(t[2])};
}

/// Whether the corners are the same, in whatever order.
bool isSame(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b) {
  return std::all_of(a.begin(), a.end(),
                     [&](const glm::dvec3& p) { return std::find(b.begin(), b.end(), p) != b.end(); });
}

}  // namespace

std::optional<Sheets::Sheet> Sheets::placed(const scene::MeshPtr& mesh, const SheetPlace& place,
                                            const glm::dvec4& plane) {
  const glm::dvec4 clip = glm::transpose(glm::inverse(place.clipFromObject)) * plane;
  Sheet sheet{
      mesh, place, {-clip.x / clip.z, -clip.y / clip.z, -clip.w / clip.z}, glm::dvec2(1), glm::dvec2(-1)};
  // Seen edge-on it covers nothing.
  for (int c = 0; c < 3; ++c)
    if (!(std::abs(sheet.plane[c]) < 1e9)) return std::nullopt;
  for (uint32_t t = 0; t < mesh->triangleCount; ++t) {
    for (uint32_t k = 0; k < 3; ++k) {
      const glm::dvec4 p = place.clipFromObject * glm::dvec4(position(*mesh, t, k), 1);
      sheet.before = sheet.before && p.w > 0;
      const glm::dvec2 at = glm::dvec2(p) / p.w;
      sheet.lower = glm::min(sheet.lower, at), sheet.upper = glm::max(sheet.upper, at);
    }
  }
  if (!sheet.before) sheet.lower = glm::dvec2(-1), sheet.upper = glm::dvec2(1);
  sheet.lower = glm::max(sheet.lower, glm::dvec2(-1)), sheet.upper = glm::min(sheet.upper, glm::dvec2(1));
  if (!(sheet.lower.x < sheet.upper.x && sheet.lower.y < sheet.upper.y)) return std::nullopt;
  return sheet;
}

Sheets::Corners Sheets::corners(const Sheet& sheet, uint32_t triangle) {
  Corners all;
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::dvec4 p = sheet.place.clipFromObject * glm::dvec4(position(*sheet.mesh, triangle, k), 1);
    all[k] = glm::dvec3(p) / p.w;
  }
  return all;
}

bool Sheets::overlap(const Sheet& a, const Sheet& b) {
  if (a.place.framebuffer != b.place.framebuffer || a.place.viewport != b.place.viewport) return false;
  if (!(a.place.offset == b.place.offset)) return false;
  const glm::dvec2 lower = glm::max(a.lower, b.lower), upper = glm::min(a.upper, b.upper);
  if (!(lower.x + kNarrow < upper.x && lower.y + kNarrow < upper.y)) return false;
  // Eight steps of 24 bits, or four of what is coarser: as far as rasterisers round.
  const double most = std::max(0x1p-20, 8.0 * double{a.place.offset.resolution});
  const glm::dvec3 apart = a.plane - b.plane;
  for (const double x : {lower.x, upper.x})
    for (const double y : {lower.y, upper.y})
      if (!(std::abs(apart.x * x + apart.y * y + apart.z) <= most)) return false;
  constexpr uint64_t kMostPairs = 65536;  // beyond them the bounds decide
  const uint64_t pairs = uint64_t{a.mesh->triangleCount} * b.mesh->triangleCount;
  if (!a.before || !b.before || pairs > kMostPairs)
    return a.mesh->geometryId != b.mesh->geometryId || a.place.clipFromObject != b.place.clipFromObject;
  std::vector<Corners> others;
  for (uint32_t t = 0; t < b.mesh->triangleCount; ++t) others.push_back(corners(b, t));
  for (uint32_t t = 0; t < a.mesh->triangleCount; ++t) {
    const Corners one = corners(a, t);
    const Corners2 here = flat(one);
    for (const Corners& other : others)
      if (!isApart(here, flat(other)) && !isApart(flat(other), here) && !isSame(one, other)) return true;
  }
  return false;
}

bool Sheets::meets(const scene::MeshPtr& mesh, const SheetPlace& place) {
  if (mesh->shape != scene::Shape::triangles || mesh->triangleCount == 0 ||
      mesh->triangleCount > kMostTriangles)
    return false;
  const std::optional<glm::dvec4>& plane = planeOf(*mesh);
  if (!plane || sheets_.size() >= kMostSheets) return false;
  std::optional<Sheet> sheet = placed(mesh, place, *plane);
  if (!sheet) return false;
  bool met = isRemembered(mesh->geometryId);
  for (const Sheet& other : sheets_) {
    if (!overlap(other, *sheet)) continue;
    found_ = found_ || !met || !isRemembered(other.mesh->geometryId);
    met = true;
    remember(other.mesh->geometryId), remember(mesh->geometryId);
  }
  sheets_.push_back(std::move(*sheet));
  return met;
}

void Sheets::clear() {
  if (sheets_.empty()) return;
  sheets_.clear();
  ++layer_;
}

void Sheets::remember(const Hash128& geometry) {
  constexpr size_t kMost = 4096;  // more are old ones that are drawn no more
  if (metIn_.size() > kMost) metIn_.clear();
  metIn_[geometry] = layer_;
}

bool Sheets::isRemembered(const Hash128& geometry) {
  constexpr uint64_t kRemembered = 100;  // layers
  const auto met = metIn_.find(geometry);
  if (met == metIn_.end()) return false;
  if (layer_ <= met->second + kRemembered) return true;
  metIn_.erase(met);
  return false;
}

const std::optional<glm::dvec4>& Sheets::planeOf(const scene::Mesh& mesh) {
  constexpr size_t kMost = 4096;
  if (planes_.size() > kMost) planes_.clear();
  const auto known = planes_.find(mesh.geometryId);
  if (known != planes_.end()) return known->second;
  return planes_.emplace(mesh.geometryId, findPlane(mesh)).first->second;
}

}  // namespace gluray::gl
