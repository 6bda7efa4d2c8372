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

/// A corner in clip space, as the shader has it: in floats.
glm::vec4 clipOf(const Surface& surface, uint32_t primitive, uint32_t corner) {
  const glm::vec3 object = surface.mesh->position(surface.mesh->corner(primitive, corner));
  return glm::vec4(surface.clipFromObject * glm::dvec4(object, 1));
}

/// The window position that the geometry shader computes in floats. Where a triangle's corners coincide after
/// rounding, its directions are no numbers.
glm::dvec2 positionOf(const glm::vec4& clip, const glm::ivec4& viewport) {
  const glm::vec2 from(viewport.x, viewport.y), size(viewport.z, viewport.w);
  return (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * size + from;
}

constexpr WindowBox kEverywhere{glm::dvec2(-HUGE_VAL), glm::dvec2(HUGE_VAL)};

}  // namespace

EdgedTriangle::EdgedTriangle(const Surface& surface, const scene::Camera& camera, uint32_t primitive) {
  const scene::FragmentShading& f = surface.lighting->shading->fragment;
  const glm::dvec2 half = glm::dvec2(camera.viewport.z, camera.viewport.w) * 0.5,
                   centre = glm::dvec2(camera.viewport.x, camera.viewport.y) + half;
  const scene::Instance& instance = *surface.instance;
  const size_t index = static_cast<size_t>(instance.triangleOffset) + primitive;
  const uint32_t flags =
      instance.triangleEdges ? static_cast<uint32_t>(instance.triangleEdges.data[index]) : 7;
  width_ = f.edgeWidth;
  opacity_ = f.edgeOpacity;
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::dvec4 clip = clipOf(surface, primitive, k);
    corner_[k] = positionOf(clip, camera.viewport);
    moved_[k] = {centre * clip.w + half * glm::dvec2(clip), clip.w};
    depth_[k] = clip.z;
    hidden_[k] = !(flags >> k & 1);
    crosses_ = crosses_ || !(clip.w > 0);
  }
  const double turned = cross(corner_[1] - corner_[0], corner_[2] - corner_[0]), turn = turned < 0 ? -1 : 1;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 along = unit(corner_[(k + 1) % 3] - corner_[k]);
    inward_[k] = turn * glm::dvec2(-along.y, along.x);
  }
  for (int k = 0; k < 3 && f.edgesGrow; ++k) {
    const glm::dvec2 outwards = -0.25 * width_ * unit(inward_[(k + 2) % 3] + inward_[k]);
    moved_[k] += glm::dvec3(outwards * moved_[k].z, 0);
  }
  // Without an area in the window, the geometry shader's directions are no numbers.
  const double area = glm::dot(moved_[0], glm::cross(moved_[1], moved_[2]));
  if (turned == 0 || area == 0 || !std::isfinite(area)) return;
  for (int k = 0; k < 3; ++k) shareOf_[k] = glm::cross(moved_[(k + 1) % 3], moved_[(k + 2) % 3]) / area;
}

std::optional<WindowBox> windowBoxOf(const Surface& surface, const scene::Camera& camera,
                                     uint32_t primitive) {
  const glm::dvec2 half = glm::dvec2(camera.viewport.z, camera.viewport.w) * 0.5,
                   centre = glm::dvec2(camera.viewport.x, camera.viewport.y) + half;
  WindowBox box{glm::dvec2(HUGE_VAL), glm::dvec2(-HUGE_VAL)};
  int behind = 0;
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::dvec4 clip = clipOf(surface, primitive, k);
    const glm::dvec2 corner = centre + half * glm::dvec2(clip) / clip.w;
    box.lower = glm::min(box.lower, corner), box.upper = glm::max(box.upper, corner);
    behind += !(clip.w > 0);
  }
  if (behind == 3) return std::nullopt;
  return behind ? kEverywhere : box;
}

WindowBox EdgedTriangle::bounds() const {
  if (crosses_) return kEverywhere;
  WindowBox box{glm::dvec2(HUGE_VAL), glm::dvec2(-HUGE_VAL)};
  for (const glm::dvec3& p : moved_) {
    const glm::dvec2 corner = glm::dvec2(p) / p.z;
    box.lower = glm::min(box.lower, corner), box.upper = glm::max(box.upper, corner);
  }
  return box;
}

std::array<HalfPlane, 6> EdgedTriangle::grown() const {
  std::array<HalfPlane, 6> planes;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3& form = shareOf_[k];
    const double length = glm::length(glm::dvec2(form));
    const auto at = static_cast<size_t>(k);
    if (length > 0)
      planes[at] = {glm::dvec2(form) / length, -form.z / length};
    else
      planes[at] = {glm::dvec2(0), form.z > 0 ? -HUGE_VAL : HUGE_VAL};
    planes[at + 3] = {inward_[k], hidden_[k] ? glm::dot(inward_[k], corner_[k]) - 0.5 : -HUGE_VAL};
  }
  return planes;
}

std::array<HalfPlane, 3> EdgedTriangle::own() const {
  std::array<HalfPlane, 3> planes;
  for (size_t k = 0; k < 3; ++k)
    planes[k] = {inward_[k], crosses_ ? HUGE_VAL : glm::dot(inward_[k], corner_[k])};
  return planes;
}

bool EdgedTriangle::covers(const glm::dvec2& at) const {
  const glm::dvec3 b = shares(at);
  if (!(b.x >= 0 && b.y >= 0 && b.z >= 0 && b.x + b.y + b.z > 0)) return false;
  for (int k = 0; k < 3; ++k)
    if (hidden_[k] && distance(k, at) < -0.5) return false;
  return true;
}

double EdgedTriangle::ndcDepth(const glm::dvec2& at) const { return glm::dot(shares(at), depth_); }

glm::vec2 EdgedTriangle::weights(const glm::dvec2& at) const {
  const glm::dvec3 b = shares(at);
  const double sum = b.x + b.y + b.z;
  return glm::vec2(b.y / sum, b.z / sum);
}

float EdgedTriangle::edgeShare(const glm::dvec2& at) const {
  double nearest = HUGE_VAL;
  for (int k = 0; k < 3; ++k) nearest = std::min(nearest, distance(k, at) + (hidden_[k] ? width_ : 0));
  return opacity_ * static_cast<float>(std::clamp(0.5 + 0.5 * width_ - nearest, 0.0, 1.0));
}

}  // namespace gluray::render
