// Scenes for the tests of path tracing.
#pragma once
#include "render/testing/test_ball.h"
#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gluray::test {

constexpr int kPathSize = 32;

/// Lit meshes of white diffuse surfaces without lights in the view of a camera at (0, 0, 5) that looks at the
/// origin; y is up. The environment is white, of strength 1.
inline scene::Snapshot pathView(const std::vector<scene::MeshPtr>& meshes) {
  scene::Snapshot s = makeSnapshot(meshes, kPathSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  s.shadings[0].lighting = true;
  for (scene::Instance& instance : s.instances) {
    instance.eyeFromObject = s.eyeFromWorld;
    scene::MaterialPair& pair = instance.materials[0];
    pair.front.diffuse = glm::vec4(1);
    pair.back = pair.front;
  }
  s.wideColors = true;
  s.settings.integrator = LightIntegrator::path;
  s.settings.path.samples = 256;
  s.settings.path.lights = 1;
  s.settings.path.clamp = 0;
  s.settings.environment.strength = 1;
  return s;
}

inline void setAlbedo(scene::Instance& instance, const glm::vec3& albedo) {
  for (scene::Material* m : {&instance.materials[0].front, &instance.materials[0].back})
    m->diffuse = glm::vec4(albedo, 1);
}

/// The wall z = 0 that fills the view.
inline scene::MeshPtr backWall() { return parallelogram({0, 0, 0}, {500, 0, 0}, {0, 500, 0}); }

/// An image of float colours.
struct Radiances {
  Traced traced;
  bool hit(int x, int y) const { return traced.hit(x, y); }
  glm::vec3 at(int x, int y) const {
    const float* c = traced.image.wideColor.data() + 4 * traced.at(x, y, 0);
    return {c[0], c[1], c[2]};
  }
  /// Over the pixels of [x0, x1) that hit.
  glm::vec3 mean(int x0 = 0, int x1 = kPathSize) const {
    glm::dvec3 sum(0);
    int count = 0;
    for (int y = 0; y < kPathSize; ++y)
      for (int x = x0; x < x1; ++x)
        if (hit(x, y)) sum += glm::dvec3(at(x, y)), ++count;
    EXPECT_GT(count, 0);
    return glm::vec3(sum / static_cast<double>(std::max(count, 1)));
  }
};

inline Radiances radiances(const scene::Snapshot& s) { return {trace(s)}; }

}  // namespace gluray::test
