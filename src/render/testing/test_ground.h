// A plate over a ground, and what the ground shows by plain arithmetic, for tests.
#pragma once
#include "render/ground/staged_scene.h"
#include "render/testing/lit_wall.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::test {

inline Traced traceStaged(const scene::Snapshot& s) {
  const render::StagedScene staged(s);
  Arena arena(2);
  accel::World world;
  world.update(staged.snapshot(), arena, staged.hidden());
  Traced traced;
  render::traceImage(staged.snapshot(), world, arena, traced.image);
  return traced;
}

constexpr double kPlateHeight = 0.4;  // of the plate above the eye
inline const double kBelow =
    std::sqrt(2.0) - kPlateHeight;               // of the ground below the eye: one diagonal of the plate
inline const double kHalf = 5 * std::sqrt(2.0);  // of the ground's width

/// A level plate of width 1 over a ground one diagonal below, lit from straight above. The viewer at (0, 0,
/// 5) looks along -z.
inline scene::Snapshot plate(GroundKind kind, double size = 1, double near = 0.1, double far = 1000) {
  const auto z = static_cast<float>(size);
  auto mesh = makeMesh(quadData(glm::vec3(-0.5f, 0.4f, -0.5f) * z, glm::vec3(0.5f, 0.4f, -0.5f) * z,
                                glm::vec3(0.5f, 0.4f, 0.5f) * z, glm::vec3(-0.5f, 0.4f, 0.5f) * z));
  mesh->lower = glm::vec3(-0.5f, 0.4f, -0.5f) * z, mesh->upper = glm::vec3(0.5f, 0.4f, 0.5f) * z;
  scene::Snapshot s = litView({mesh}, Shader::fixedFunction, {0, 1, 0, 0});
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, near * size, far * size);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5 * size});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.ground.kind = kind;
  s.settings.ground.offset = 1;
  s.settings.ground.color = glm::vec3(1);
  s.ground = scene::GroundUse::drawn;
  return s;
}

/// Where the ray through a pixel meets the ground, by plain arithmetic.
inline glm::dvec3 onGround(int x, int y) {
  const double slope = std::tan(glm::radians(20.0));
  const glm::dvec3 way(((x + 0.5) / (kLitSize / 2) - 1) * slope, ((y + 0.5) / (kLitSize / 2) - 1) * slope,
                       -1);
  const double t = -kBelow / way.y;
  return t > 0 ? glm::dvec3(0, 0, 5) + t * way : glm::dvec3(1e9);
}
inline bool isOnGround(const glm::dvec3& p) { return std::abs(p.x) <= kHalf && std::abs(p.z) <= kHalf; }
/// Not at the rim of the shadow nor of the ground.
inline bool isClearCase(const glm::dvec3& p) {
  const double m = std::max(std::abs(p.x), std::abs(p.z));
  return std::abs(m - 0.5) > 0.02 && std::abs(m - kHalf) > 0.2;
}
inline bool isShadowed(const glm::dvec3& p) { return std::abs(p.x) < 0.5 && std::abs(p.z) < 0.5; }

}  // namespace gluray::test
