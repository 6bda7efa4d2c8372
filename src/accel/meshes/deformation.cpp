#include "accel/meshes/deformation.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace gluray::accel {
namespace {

constexpr size_t kGroup = 8, kGroups = 512;

glm::vec3 position(const scene::Mesh& mesh, uint32_t vertex) {
  glm::vec3 p;
  std::memcpy(&p, mesh.positions.data + static_cast<size_t>(vertex) * mesh.positions.stride, sizeof p);
  return p;
}

uint32_t corner(const scene::Mesh& mesh, uint32_t triangle, uint32_t k) {
  const size_t at = static_cast<size_t>(triangle) * 3 + k;
  if (!mesh.indices) return static_cast<uint32_t>(at);
  uint32_t vertex;
  std::memcpy(&vertex, mesh.indices.data + at * 4, 4);
  return vertex;
}

struct Extent {
  glm::vec3 lower{std::numeric_limits<float>::max()}, upper{std::numeric_limits<float>::lowest()};
  void add(glm::vec3 p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  double area() const {
    const glm::dvec3 d(glm::max(upper - lower, glm::vec3(0)));
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

/// Morton code: interleaves ten bits of each coordinate within the box.
uint32_t mortonCode(glm::vec3 p, const Extent& box) {
  const auto spread = [](uint32_t v) {
    v = (v | v << 16) & 0x030000ff;
    v = (v | v << 8) & 0x0300f00f;
    v = (v | v << 4) & 0x030c30c3;
    return (v | v << 2) & 0x09249249;
  };
  const glm::vec3 size = glm::max(box.upper - box.lower, glm::vec3(1e-30f));
  const glm::vec3 at = glm::clamp((p - box.lower) / size, 0.0f, 1.0f) * 1023.0f;
  return spread(static_cast<uint32_t>(at.x)) | spread(static_cast<uint32_t>(at.y)) << 1 |
         spread(static_cast<uint32_t>(at.z)) << 2;
}

}  // namespace

bool allInReach(const scene::Mesh& mesh) {
  constexpr float kReach = 1e18f;
  constexpr uint32_t kBlock = 4096;  // vertices per branch
  for (uint32_t first = 0; first < mesh.vertexCount; first += kBlock) {
    const uint32_t end = std::min(mesh.vertexCount, first + kBlock);
    bool fine = true;
    for (uint32_t v = first; v < end; ++v) {
      const glm::vec3 p = glm::abs(position(mesh, v));
      fine = fine & (p.x < kReach) & (p.y < kReach) & (p.z < kReach);  // false for NaN
    }
    if (!fine) return false;
  }
  return true;
}

Neighbours::Neighbours(const scene::Mesh& mesh) {
  const uint32_t step = std::max<uint32_t>(1, mesh.triangleCount / (kGroup * kGroups));
  Extent all;
  std::vector<std::pair<uint32_t, uint32_t>> byPlace;
  for (uint32_t t = 0; t < mesh.triangleCount; t += step) all.add(position(mesh, corner(mesh, t, 0)));
  for (uint32_t t = 0; t < mesh.triangleCount; t += step)
    byPlace.emplace_back(mortonCode(position(mesh, corner(mesh, t, 0)), all), t);
  std::sort(byPlace.begin(), byPlace.end());
  triangles_.reserve(byPlace.size());
  for (const auto& [code, triangle] : byPlace) triangles_.push_back(triangle);
  triangles_.resize(triangles_.size() / kGroup * kGroup);
  share_ = areaShare(mesh);
}

double Neighbours::areaShare(const scene::Mesh& mesh) const {
  Extent all;
  double sum = 0;
  for (size_t first = 0; first < triangles_.size(); first += kGroup) {
    Extent group;
    for (size_t i = first; i < first + kGroup; ++i)
      for (uint32_t k = 0; k < 3; ++k) group.add(position(mesh, corner(mesh, triangles_[i], k)));
    sum += group.area();
    all.add(group.lower), all.add(group.upper);
  }
  return sum / std::max(all.area(), 1e-300);
}

double Neighbours::spreadIn(const scene::Mesh& mesh) const {
  return share_ > 0 ? areaShare(mesh) / share_ : 1;
}

Deformations::Step Deformations::stepFor(const scene::Mesh& mesh, double spread) {
  constexpr size_t kMaxCourses = 256;
  constexpr int kSettled = 2;     // first changes that are built normally: there may be no more
  constexpr double kFar = 2;      // spread from which rays lose more time than the refit saves
  constexpr int kWorthwhile = 6;  // refits that make up for the slower build
  constexpr int kPause = 60;
  if (courses_.size() > kMaxCourses) courses_.clear();
  Course& course = courses_[{mesh.vertexCount, mesh.triangleCount}];
  if (course.pause > 0) return --course.pause, Step::build;
  if (spread > 0 && spread <= kFar) return ++course.refits, Step::refit;
  if (spread > kFar && course.refits < kWorthwhile) {
    course = {0, 0, kPause};
    return Step::build;
  }
  if (++course.steps <= kSettled) return Step::build;
  course.refits = 0;
  return Step::buildToRefit;
}

void Deformations::comesAround(const scene::Mesh& mesh) {
  constexpr int kLongPause = 600;
  courses_[{mesh.vertexCount, mesh.triangleCount}] = {0, 0, kLongPause};
}

}  // namespace gluray::accel
