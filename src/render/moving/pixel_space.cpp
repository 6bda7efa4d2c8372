#include "render/moving/pixel_space.h"

#include "scene/box_corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

/// Least and largest dot(axis, corner) of the world's bounds in eye space.
glm::dvec2 extent(const FrameData& frame, const glm::dvec3& axis) {
  const glm::dmat4& eyeFromWorld = frame.snapshot->eyeFromWorld;
  const accel::Bounds seen = frame.world->seenBounds();
  glm::dvec2 range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 world(scene::boxCorner(seen.lower, seen.upper, corner), 1);
    const double along = glm::dot(axis, glm::dvec3(eyeFromWorld * world));
    range = {std::min(range.x, along), std::max(range.y, along)};
  }
  return range;
}

bool finite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

}  // namespace

PixelSpace::PixelSpace(const FrameData& frame) {
  const RaySetup& setup = frame.eyeRays;
  const LinearRays& rays = setup.linear;
  const scene::Region& region = frame.snapshot->region;
  if (!rays.usable) return;
  const glm::dvec3 right = rays.orgX / glm::length(rays.orgX), up = rays.orgY / glm::length(rays.orgY);
  // Normal to the planes on which all pixels have the same t.
  glm::dvec3 axis = glm::normalize(glm::cross(right, up));
  const double x0 = region.x + 0.5, y0 = region.y + 0.5;
  const glm::dvec3 org = rays.org + x0 * rays.orgX + y0 * rays.orgY,
                   dir = rays.dir + x0 * rays.dirX + y0 * rays.dirY;
  if (glm::dot(axis, dir) < 0) axis = -axis;
  const double slope = glm::dot(axis, dir), atOrg = glm::dot(axis, org);
  const glm::dvec2 range = extent(frame, axis);
  // depth = scale * dot(axis, p) + offset
  const bool perspective = glm::length(rays.dirX) + glm::length(rays.dirY) > 0;
  double scale, offset;
  if (perspective) {
    const glm::dvec3 eye = glm::dvec3(setup.step) / setup.step.w;
    scale = 1 / ((range.y - glm::dot(axis, eye)) * (1 + 1e-6));
    offset = -scale * glm::dot(axis, eye);
  } else {
    const double thickness =
        std::max(range.y - range.x, 1e-6 * std::max(std::abs(range.x), std::abs(range.y)));
    scale = 1 / (thickness * (1 + 1e-3));
    offset = 1 - scale * (range.x - 5e-4 * thickness);
  }
  // p = org + t * dir, t = (along - atOrg) / slope, along = (depth - offset) / scale
  const double perDepthT = 1 / (scale * slope), t0 = (-offset / scale - atOrg) / slope;
  base = glm::vec3(org + t0 * dir), ray = glm::vec3(perDepthT * dir);
  baseX = glm::vec3(rays.orgX + t0 * rays.dirX), rayX = glm::vec3(perDepthT * rays.dirX);
  baseY = glm::vec3(rays.orgY + t0 * rays.dirY), rayY = glm::vec3(perDepthT * rays.dirY);
  depth = glm::vec4(scale * axis, offset);
  const auto size = [](const glm::vec3& v) { return static_cast<float>(glm::length(glm::dvec3(v))); };
  pixel = std::max(size(baseX), size(baseY)), perDepth = std::max(size(rayX), size(rayY));
  const glm::ivec4& v = frame.snapshot->camera.viewport;
  const glm::dvec2 half(0.5 * v.z, 0.5 * v.w), middle(v.x + half.x - x0, v.y + half.y - y0);
  const glm::dmat4 pixelFromClip(half.x, 0, 0, 0, 0, half.y, 0, 0, 0, 0, 1, 0, middle.x, middle.y, 0, 1);
  pixelFromEye = pixelFromClip * frame.snapshot->camera.clipFromEye;
  usable =
      std::isfinite(scale) && scale > 0 && finite(ray) && finite(base) && std::isfinite(pixel + perDepth);
}

}  // namespace gluray::render
