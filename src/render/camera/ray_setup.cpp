#include "render/camera/ray_setup.h"

#include "scene/failure.h"

#include <cmath>

namespace gluray::render {
namespace {

bool finite(const glm::dmat4& m) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      if (!std::isfinite(m[c][r])) return false;
    }
  }
  return true;
}

glm::dmat4 invert(const glm::dmat4& m, const char* what) {
  const glm::dmat4 inverse = glm::inverse(m);
  if (!finite(m) || !finite(inverse)) throw scene::Untraceable(std::string(what) + " cannot be inverted");
  return inverse;
}

/// Start of the ray through the middle of the viewport.
glm::dvec4 middleOf(const RaySetup& rays, const glm::ivec4& viewport) {
  return rays.start + (viewport.x + 0.5 * viewport.z) * rays.startX +
         (viewport.y + 0.5 * viewport.w) * rays.startY;
}

// Length of the direction of the ray through the middle of the viewport, as in the kernels before scaling.
double middleDirectionLength(const RaySetup& rays, const glm::ivec4& viewport) {
  const glm::dvec4 s = middleOf(rays, viewport);
  const glm::dvec3 origin = glm::dvec3(s) / s.w;
  return glm::length((glm::dvec3(rays.step) - origin * rays.step.w) / s.w);
}

void placeOrigins(RaySetup& rays, const glm::ivec4& viewport, const glm::vec3& lower,
                  const glm::vec3& upper) {
  constexpr double kFarAway = 64;  // distance of the viewer in radii of the scene
  rays.sphereCenter = 0.5 * (glm::dvec3(lower) + glm::dvec3(upper));
  rays.sphereRadius = 0.5 * glm::length(glm::dvec3(upper) - glm::dvec3(lower));
  const glm::dvec4 s = middleOf(rays, viewport);
  const double distance = glm::length(glm::dvec3(s) / s.w - rays.sphereCenter);
  rays.startAtSphere = std::isfinite(distance) && distance > kFarAway * rays.sphereRadius;
}

// Whether w is constant over the window, up to the rounding of matrices that programs multiply in float. The
// resulting error of rays is as small as the rounding of their origins.
bool sameEverywhere(const RaySetup& rays, const glm::ivec4& viewport) {
  const double change = std::abs(rays.startX.w) * viewport.z + std::abs(rays.startY.w) * viewport.w;
  return change <= 0x1p-22 * std::abs(middleOf(rays, viewport).w);
}

// Requires constant w over the window: origins and directions then need no division.
LinearRays makeLinearRays(const RaySetup& rays, const glm::ivec4& viewport, const scene::Region& region) {
  const double w = middleOf(rays, viewport).w, scale = rays.directionScale / w;
  LinearRays linear;
  linear.org = glm::dvec3(rays.start) / w;
  linear.orgX = glm::dvec3(rays.startX) / w;
  linear.orgY = glm::dvec3(rays.startY) / w;
  linear.dir = (glm::dvec3(rays.step) - linear.org * rays.step.w) * scale;
  linear.dirX = -linear.orgX * (rays.step.w * scale);
  linear.dirY = -linear.orgY * (rays.step.w * scale);
  const double end = 1 + 2 * rays.step.w / w;  // w at the far end / w; 0: the far plane is at infinity
  linear.tFar = static_cast<float>(end > 1e-12 ? 2 / (end * rays.directionScale) : HUGE_VAL);
  linear.orgStepX = glm::vec3(linear.orgX), linear.orgStepY = glm::vec3(linear.orgY);
  linear.dirStepX = glm::vec3(linear.dirX), linear.dirStepY = glm::vec3(linear.dirY);
  linear.usable = sameEverywhere(rays, viewport) && w > 0 && !rays.startAtSphere;
  for (const double x : {region.x, region.x + region.width}) {
    for (const double y : {region.y, region.y + region.height}) {
      const glm::dvec3 org = glm::abs(linear.org + x * linear.orgX + y * linear.orgY);
      const glm::dvec3 dir = glm::abs(linear.dir + x * linear.dirX + y * linear.dirY);
      for (int c = 0; c < 3; ++c) linear.usable &= org[c] < kLargestRay && dir[c] < kLargestRay;
    }
  }
  return linear;
}

}  // namespace

WindowMap::WindowMap(const glm::ivec4& viewport) {
  if (viewport.z <= 0 || viewport.w <= 0) throw scene::Untraceable("the viewport has no area");
  const glm::dvec2 corner(viewport.x, viewport.y), size(viewport.z, viewport.w);
  ndcScale = 2.0 / size;
  ndcOffset = -1.0 - corner * ndcScale;
}

namespace {

// With a reversed glDepthRange and GL_LESS rays start at the far plane. If that is at infinity, starts them
// before it, where depth is almost equal.
void startInSight(RaySetup& rays, const glm::ivec4& viewport) {
  constexpr double kNearlyInfinite = 0x1p-30;  // of the w at the other end; with less, origins would jitter
  const double w = middleOf(rays, viewport).w, end = w + 2 * rays.step.w, least = kNearlyInfinite * end;
  if (end > 0 && w < least) rays.start += (least - w) / rays.step.w * rays.step;
}

// Starts and steps in the space that `fromClip` maps to.
RaySetup makeSteps(const scene::Camera& camera, const glm::dmat4& fromClip) {
  const WindowMap window(camera.viewport);
  const double nearest = camera.firstNdcDepth();
  RaySetup rays;
  rays.startX = fromClip[0] * window.ndcScale.x;
  rays.startY = fromClip[1] * window.ndcScale.y;
  rays.start = fromClip * glm::dvec4(window.ndcOffset, nearest, 1.0);
  rays.step = -nearest * fromClip[2];
  startInSight(rays, camera.viewport);
  return rays;
}

}  // namespace

// Offset of rays from their samples. Rasterisers assign a sample on an edge to the triangle on its right, and
// on a horizontal edge to the one above: as if samples lay slightly to the right and, even less, up. The
// offset is much smaller than the snapping of vertices (1/256 pixel) and larger than the rounding of rays. It
// is no binary fraction, so that edges between corners on a grid miss the offset samples. Depths and
// impostors are computed at the samples themselves (docs/adr/0037).
constexpr glm::dvec2 kBesideEdges{2.3e-4, 2.9e-5};  // pixels

RaySetup makeRaySetup(const scene::Snapshot& snapshot, const glm::vec3& lower, const glm::vec3& upper) {
  const scene::Camera& camera = snapshot.camera;
  const glm::dmat4 worldFromClip = invert(snapshot.eyeFromWorld, "the modelview matrix") *
                                   invert(camera.clipFromEye, "the projection matrix");
  RaySetup rays = makeSteps(camera, worldFromClip);
  rays.start += kBesideEdges.x * rays.startX + kBesideEdges.y * rays.startY;
  const double length = middleDirectionLength(rays, camera.viewport);
  if (std::isfinite(length) && length > 0) rays.directionScale = 1.0 / length;
  placeOrigins(rays, camera.viewport, lower, upper);
  rays.linear = makeLinearRays(rays, camera.viewport, snapshot.region);
  return rays;
}

RaySetup makeEyeRays(const scene::Snapshot& snapshot, const RaySetup& inWorld) {
  RaySetup rays = makeSteps(snapshot.camera, invert(snapshot.camera.clipFromEye, "the projection matrix"));
  rays.directionScale = inWorld.directionScale;
  rays.linear = makeLinearRays(rays, snapshot.camera.viewport, snapshot.region);
  return rays;
}

}  // namespace gluray::render
