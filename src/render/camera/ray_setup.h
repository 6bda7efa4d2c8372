// Coefficients that map window pixels to rays in world space. Made once per frame on the calling thread, read
// by every tracing thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::render {

/// Rays whose origin and direction are linear in the window position, as in every ordinary projection:
///   origin = org + x*orgX + y*orgY, direction = dir + x*dirX + y*dirY, t in [0, tFar].
struct LinearRays {
  bool usable = false;
  glm::dvec3 org{0}, orgX{0}, orgY{0}, dir{0}, dirX{0}, dirY{0};
  float tFar = 0;
  // The same steps in float, for use within a packet.
  glm::vec3 orgStepX{0}, orgStepY{0}, dirStepX{0}, dirStepY{0};
};

/// The homogeneous world-space points at window position (x, y):
///   start + x*startX + y*startY + k*step,  k = 0 on the plane at which the depth test's order begins (the
///   near plane unless glDepthRange is reversed), k = 2 on the opposite one.
/// A point is in front of the viewer if its w is positive. Holds for every invertible projection.
struct RaySetup {
  glm::dvec4 start{0}, startX{0}, startY{0}, step{0};
  double directionScale = 1;           // makes ray directions about one world unit long
  std::vector<glm::dvec4> clipPlanes;  // world space; points with dot(plane, p) < 0 are clipped
  // If the viewer is so far away that float origins would jitter, rays start at this sphere instead.
  bool startAtSphere = false;
  glm::dvec3 sphereCenter{0};
  double sphereRadius = 0;
  LinearRays linear;  // the same rays without clip planes, if usable
};

constexpr double kLargestRay = 1e18;  // Embree's limit on the coordinates of origins and directions

/// NDC x = ndcScale.x * windowX + ndcOffset.x, likewise y.
struct WindowMap {
  glm::dvec2 ndcScale, ndcOffset;
  explicit WindowMap(const glm::ivec4& viewport);
  glm::dvec2 ndcOf(const glm::dvec2& window) const { return window * ndcScale + ndcOffset; }
};

/// Rays of the snapshot's camera for a world within the given bounds. Throws std::runtime_error if the
/// projection, the modelview matrix or the viewport cannot be inverted.
RaySetup makeRaySetup(const scene::Snapshot&, const glm::vec3& lower, const glm::vec3& upper);

/// The same rays in eye space, without clip planes and starting at the near plane.
RaySetup makeEyeRays(const scene::Snapshot&, const RaySetup& inWorld);

}  // namespace gluray::render
