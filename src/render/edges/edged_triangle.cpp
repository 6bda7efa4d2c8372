#include "render/edges/edged_triangle.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

glm::dvec2 unit(const glm::dvec2& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec2(0);
}

}  // namespace

EdgedTriangle::EdgedTriangle(const Surface& surface, const scene::Camera& camera, uint32_t primitive) {
  const scene::FragmentShading& f = surface.lighting->shading->fragment;
  const glm::dvec2 half = glm::dvec2(camera.viewport.z, camera.viewport.w) * 0.5,
                   centre = glm::dvec2(camera.viewport.x, camera.viewport.y) + half;
  const scene::Instance& instance = *surface.instance;
  const auto flags = static_cast<uint32_t>(
      instance.triangleEdges.data[static_cast<size_t>(instance.triangleOffset) + primitive]);
  width_ = f.edgeWidth;
  opacity_ = f.edgeOpacity;
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::dvec4 clip =
        surface.clipFromObject * glm::dvec4(surface.mesh->position(surface.mesh->corner(primitive, k)), 1);
    corner_[k] = centre + half * glm::dvec2(clip) / clip.w;
    depth_[k] = clip.z / clip.w;
    w_[k] = clip.w;
    hidden_[k] = !(flags >> k & 1);
  }
  const double turn = cross(corner_[1] - corner_[0], corner_[2] - corner_[0]) < 0 ? -1 : 1;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 along = unit(corner_[(k + 1) % 3] - corner_[k]);
    inward_[k] = turn * glm::dvec2(-along.y, along.x);
  }
  for (int k = 0; k < 3; ++k)
    moved_[k] = corner_[k] - (f.edgesGrow ? 0.25 * width_ : 0.0) * unit(inward_[(k + 2) % 3] + inward_[k]);
  area_ = cross(moved_[1] - moved_[0], moved_[2] - moved_[0]);
}

std::optional<WindowBox> windowBoxOf(const Surface& surface, const scene::Camera& camera,
                                     uint32_t primitive) {
  const glm::dvec2 half = glm::dvec2(camera.viewport.z, camera.viewport.w) * 0.5,
                   centre = glm::dvec2(camera.viewport.x, camera.viewport.y) + half;
  WindowBox box{glm::dvec2(HUGE_VAL), glm::dvec2(-HUGE_VAL)};
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::dvec4 clip =
        surface.clipFromObject * glm::dvec4(surface.mesh->position(surface.mesh->corner(primitive, k)), 1);
    if (!(clip.w > 0)) return std::nullopt;
    const glm::dvec2 corner = centre + half * glm::dvec2(clip) / clip.w;
    box.lower = glm::min(box.lower, corner), box.upper = glm::max(box.upper, corner);
  }
  return box;
}

std::array<HalfPlane, 6> EdgedTriangle::grown() const {
  std::array<HalfPlane, 6> planes;
  const double turn = area_ < 0 ? -1 : 1;
  for (size_t k = 0; k < 3; ++k) {
    const glm::dvec2 along = unit(moved_[(k + 1) % 3] - moved_[k]),
                     normal = turn * glm::dvec2(-along.y, along.x);
    planes[k] = {normal, glm::dot(normal, moved_[k])};
    planes[k + 3] = {inward_[k], hidden_[k] ? glm::dot(inward_[k], corner_[k]) - 0.5 : -HUGE_VAL};
  }
  return planes;
}

std::array<HalfPlane, 3> EdgedTriangle::own() const {
  std::array<HalfPlane, 3> planes;
  for (size_t k = 0; k < 3; ++k) planes[k] = {inward_[k], glm::dot(inward_[k], corner_[k])};
  return planes;
}

glm::dvec3 EdgedTriangle::barycentric(const glm::dvec2& at) const {
  const double b1 = cross(at - moved_[0], moved_[2] - moved_[0]) / area_,
               b2 = cross(moved_[1] - moved_[0], at - moved_[0]) / area_;
  return {1 - b1 - b2, b1, b2};
}

bool EdgedTriangle::covers(const glm::dvec2& at) const {
  if (area_ == 0) return false;
  const glm::dvec3 b = barycentric(at);
  if (!(b.x >= 0 && b.y >= 0 && b.z >= 0)) return false;
  for (int k = 0; k < 3; ++k)
    if (hidden_[k] && distance(k, at) < -0.5) return false;
  return true;
}

double EdgedTriangle::ndcDepth(const glm::dvec2& at) const {
  const glm::dvec3 b = barycentric(at);
  return b.x * depth_[0] + b.y * depth_[1] + b.z * depth_[2];
}

glm::vec2 EdgedTriangle::weights(const glm::dvec2& at) const {
  const glm::dvec3 b = barycentric(at) / glm::dvec3(w_[0], w_[1], w_[2]);
  const double sum = b.x + b.y + b.z;
  return glm::vec2(b.y / sum, b.z / sum);
}

float EdgedTriangle::edgeShare(const glm::dvec2& at) const {
  double nearest = HUGE_VAL;
  for (int k = 0; k < 3; ++k) nearest = std::min(nearest, distance(k, at) + (hidden_[k] ? width_ : 0));
  return opacity_ * static_cast<float>(std::clamp(0.5 + 0.5 * width_ - nearest, 0.0, 1.0));
}

}  // namespace gluray::render
