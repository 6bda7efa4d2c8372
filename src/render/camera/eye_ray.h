// A primary ray in eye space. Any thread.
#pragma once
#include "render/camera/ray_setup.h"

namespace gluray::render {

struct EyeRay {
  glm::dvec3 origin, direction;  // unit length
};

/// Returns the ray through a window position. It starts at the viewpoint, or in parallel views at the plane
/// of the eye, or at the near plane if that lies behind the eye.
inline EyeRay eyeRayAt(const RaySetup& eyeRays, double x, double y) {
  const glm::dvec4 at = eyeRays.start + x * eyeRays.startX + y * eyeRays.startY;
  const glm::dvec3 near = glm::dvec3(at) / at.w, way = glm::dvec3(eyeRays.step) - eyeRays.step.w * near;
  EyeRay ray{near, glm::normalize(way * (at.w > 0 ? 1.0 : -1.0))};
  if (eyeRays.step.w != 0)
    ray.origin = glm::dvec3(eyeRays.step) / eyeRays.step.w;
  else if (ray.direction.z < 0 && near.z < 0)
    ray.origin -= ray.direction * (near.z / ray.direction.z);
  return ray;
}

}  // namespace gluray::render
