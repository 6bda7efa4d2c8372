// Points from which the light of impostors is traced lie on the solids that other rays meet.
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::render {
namespace {

constexpr int kSolidSize = 48;

/// Two white, unlit spheres at the border of a wide view, alone.
scene::Snapshot ballsAside() {
  auto balls = std::make_shared<scene::Mesh>();
  balls->shape = scene::Shape::spheres;
  balls->vertexCount = balls->triangleCount = 2;
  balls->positions =
      test::makeAttribute<glm::vec3>({{2.5f, -2, -4}, {-2.5f, 1.5f, -4}}, scene::Format::float3);
  balls->radius = 1;
  balls->lower = {-3.5f, -3, -5}, balls->upper = {3.5f, 2.5f, -3};
  scene::Snapshot s = test::makeSnapshot({balls}, kSolidSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(80.0), 1.0, 0.1, 1000.0);
  s.instances[0].impostors.billboards = scene::Impostors::Billboards::square;
  s.settings.ao.enabled = true, s.settings.ao.samples = 64, s.settings.ao.radius = 0.2f;
  return s;
}

// A convex solid occludes nothing of itself. The points that a program shows of half spheres lie beside
// theirs.
TEST(SolidPoints, OfSpheresAndHalfSpheresAreOnTheSolid) {
  scene::Snapshot s = ballsAside();
  for (const bool hemispheres : {false, true}) {
    s.instances[0].impostors.hemispheres = hemispheres;
    const test::Traced traced = test::trace(s);
    int hits = 0, dark = 0;
    for (int y = 0; y < kSolidSize; ++y)
      for (int x = 0; x < kSolidSize; ++x) {
        hits += traced.hit(x, y);
        dark += traced.hit(x, y) && traced.color(x, y).g < 255;
      }
    EXPECT_GT(hits, 100);
    EXPECT_EQ(dark, 0) << hemispheres;
  }
}

}  // namespace
}  // namespace gluray::render
