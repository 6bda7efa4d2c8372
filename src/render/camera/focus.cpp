#include "render/camera/focus.h"

#include "render/camera/lens.h"

#include <cmath>
#include <optional>

namespace gluray::render {
namespace {

struct Ray {
  glm::dvec3 org, dir;
  double near = 0, far = HUGE_VAL;
  bool exists() const {
    bool usable = near <= far;
    for (int c = 0; c < 3; ++c) usable &= std::abs(org[c]) < kLargestRay && std::abs(dir[c]) < kLargestRay;
    return usable;
  }
};

/// The viewpoint's ray through a window position, as rays.inl.h generates it.
Ray rayThrough(const RaySetup& setup, const glm::dvec2& at) {
  const glm::dvec4 start = setup.start + at.x * setup.startX + at.y * setup.startY;
  Ray ray;
  ray.org = glm::dvec3(start) / start.w;
  ray.dir = (glm::dvec3(setup.step) - ray.org * setup.step.w) * (setup.directionScale / start.w);
  const double end = 1 + 2 * setup.step.w / start.w;
  if (end > 1e-12) ray.far = 2 / (end * setup.directionScale);
  for (const glm::dvec4& plane : setup.clipPlanes) {
    const double there = glm::dot(plane, glm::dvec4(ray.org, 1)),
                 along = glm::dot(plane, glm::dvec4(ray.dir, 0));
    if (along > 0) ray.near = std::max(ray.near, -there / along);
    if (along < 0) ray.far = std::min(ray.far, -there / along);
    if (along == 0 && there < 0) ray.far = -1;
  }
  if (!setup.startAtSphere) return ray;
  const double length = glm::length(ray.dir);
  const double entry =
      glm::dot(setup.sphereCenter - ray.org, ray.dir) / (length * length) - setup.sphereRadius / length;
  const double from = std::max(ray.near, entry);
  ray.org += from * ray.dir;
  ray.near = 0, ray.far -= from;
  return ray;
}

/// The nearest visible point on the ray, world space.
std::optional<glm::dvec3> seenOn(const accel::World& world, const accel::HitFilter& visible, const Ray& ray) {
  using accel::kLanes;
  if (!ray.exists()) return std::nullopt;
  alignas(64) int32_t valid[kLanes] = {-1};
  accel::RayPacket packet{};
  for (int i = 0; i < kLanes; ++i) {
    const glm::vec3 org(ray.org), dir(ray.dir);
    packet.orgX[i] = org.x, packet.orgY[i] = org.y, packet.orgZ[i] = org.z;
    packet.dirX[i] = dir.x, packet.dirY[i] = dir.y, packet.dirZ[i] = dir.z;
    packet.tNear[i] = static_cast<float>(ray.near), packet.tFar[i] = static_cast<float>(ray.far);
    packet.mask[i] = ~0u, packet.id[i] = static_cast<uint32_t>(i);
    packet.geometry[i] = packet.instance[i] = accel::kNoHit;
  }
  const accel::ImpostorQuery solids;
  world.intersect(valid, packet, &visible, world.hasImpostors() ? &solids : nullptr);
  if (packet.geometry[0] == accel::kNoHit) return std::nullopt;
  return ray.org + double{packet.tFar[0]} * ray.dir;
}

}  // namespace

double distanceInFocus(const scene::Snapshot& s, const RaySetup& rays, const accel::World& world,
                       const accel::HitFilter& visible) {
  const auto& camera = s.settings.camera;
  const LensAxis axis(s.camera);
  if (camera.focus > 0) return double{camera.focus} - axis.start();
  const glm::ivec4& view = s.camera.viewport;
  const glm::dvec2 share(camera.focusX, camera.focusY);
  const std::optional<glm::dvec3> seen = seenOn(
      world, visible, rayThrough(rays, glm::dvec2(view.x, view.y) + share * glm::dvec2(view.z, view.w)));
  const glm::dvec3 middle = 0.5 * (glm::dvec3(world.lower()) + glm::dvec3(world.upper()));
  return axis.distanceOf(glm::dvec3(s.eyeFromWorld * glm::dvec4(seen.value_or(middle), 1)));
}

}  // namespace gluray::render
