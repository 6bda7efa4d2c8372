// A scene with light whose answer is known, for the tests of frame/.
#pragma once
#include "accel/testing/test_scene.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/renderer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gluray::frame::test {

/// A parallelogram about `center`.
inline scene::MeshPtr plane(const glm::vec3& center, const glm::vec3& a, const glm::vec3& b) {
  return gluray::test::makeMesh(
      gluray::test::quadData(center - a - b, center + a - b, center + a + b, center - a + b));
}

enum class Hides { nothing, half, some };

/// White planes in perspective with ambient occlusion. Beside an endless wall, which stands beyond the view,
/// exactly half of the sky is hidden; plates hide some of it, more or less.
inline scene::Snapshot litScene(Hides hides = Hides::some, int size = 32, int rays = 4) {
  std::vector<scene::MeshPtr> meshes = {plane({0, 0, 0}, {500, 0, 0}, {0, 500, 0})};
  if (hides == Hides::half) meshes.push_back(plane({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f}));
  for (int i = 0; hides == Hides::some && i < 5; ++i) {
    const float t = static_cast<float>(i);
    meshes.push_back(plane({0.6f * t - 1.3f, 0.3f * t - 0.9f, 0.3f + 0.2f * t}, {0.3f, 0.1f * t, 0.2f},
                           {-0.15f, 0.4f, 0.05f * t}));
  }
  scene::Snapshot s = gluray::test::makeSnapshot(meshes, size);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.ao.enabled = true;
  s.settings.ao.samples = rays;
  s.settings.ao.radius = 100;
  return s;
}

/// Traces with a renderer of its own and counts.
struct CountingTrace {
  Renderer renderer;
  int traces = 0, failAt = 0;  // the trace that fails; 0: none
  Trace trace = [this](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error) {
    if (++traces == failAt) return error = "a test's failure", false;
    return renderer.render(s, image, cost, error);
  };
  Image image(const scene::Snapshot& s) {
    Image image;
    scene::TraceCost cost;
    std::string error;
    renderer.render(s, image, cost, error);
    return image;
  }
};

/// The mean of so many passes.
struct Refined {
  CountingTrace tracer;
  Refinement refinement;
  Image image;
  scene::TraceCost cost;
  std::string error;
  Refined(const scene::Snapshot& s, int passes) {
    Refiner refiner(s, refinement);
    for (int i = 0; i < passes; ++i) EXPECT_TRUE(refiner.pass(tracer.trace, 0, cost, error)) << error;
    refiner.show(image);
  }
};

/// Root mean square of the differences of red, green and blue, 0 .. 1, over pixels that hit.
inline double difference(const Image& a, const Image& b) {
  double sum = 0;
  int values = 0;
  for (size_t i = 0; i < a.depth.size(); ++i) {
    if (a.depth[i] == Image::kMiss) continue;
    for (size_t c = 0; c < 3; ++c, ++values) {
      const double d =
          a.has(Plane::wideColor)
              ? a.wideColor[4 * i + c] - b.wideColor[4 * i + c]
              : (double(a.color[i] >> (8 * c) & 255) - double(b.color[i] >> (8 * c) & 255)) / 255;
      sum += d * d;
    }
  }
  return std::sqrt(sum / values);
}

}  // namespace gluray::frame::test
