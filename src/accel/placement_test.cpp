// What moves is placed anew; what only rounding moves stays.
#include "accel/placement.h"

#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace gluray::accel {
namespace {

using Camera = std::function<glm::mat4(float angle)>;

glm::mat4 translation(const glm::vec3& by) { return glm::translate(glm::mat4(1), by); }

/// Circles the origin.
Camera turnedAt(float distance) {
  return [=](float angle) {
    return translation({0, 0, -distance}) * glm::rotate(glm::mat4(1), angle, glm::vec3(1, 2, 3));
  };
}

/// The same as gluLookAt multiplies it.
Camera lookingFrom(float distance) {
  return [=](float angle) {
    const glm::vec3 eye =
        distance *
        glm::normalize(glm::vec3(std::cos(angle), 0.6f + 0.3f * std::sin(2 * angle), std::sin(angle)));
    return glm::mat4(glm::mat3(glm::lookAt(eye, glm::vec3(0), glm::vec3(0, 1, 0)))) * translation(-eye);
  };
}

/// Squares `at` places as OpenGL yields them: instance transforms recovered from products of floats.
void seeFrom(scene::Snapshot& s, const glm::mat4& camera, const std::vector<glm::vec3>& at) {
  s.eyeFromWorld = camera;
  const glm::dmat4 worldFromEye = glm::inverse(s.eyeFromWorld);
  for (size_t i = 0; i < at.size(); ++i) {
    s.instances[i].eyeFromObject = glm::mat4(camera * translation(at[i]));
    s.instances[i].worldFromObject = glm::mat4(worldFromEye * s.instances[i].eyeFromObject);
  }
}

struct Placement : testing::Test {
  scene::MeshPtr square = test::makeMesh(test::squareData());
  Arena arena{2};
  World world;

  bool hits(float x, float y) const { return test::shot(world, test::raysDown(x, y)).geometry[0] != kNoHit; }
  /// Top levels that are built while the camera moves past `at`.
  uint64_t buildsOf(const Camera& camera, const std::vector<glm::vec3>& at) {
    World seen;
    auto snapshot = test::makeSnapshot(std::vector<scene::MeshPtr>(at.size(), square));
    seeFrom(snapshot, camera(0.1f), at);
    EXPECT_EQ(seen.update(snapshot, arena).tlasBuilds, 1u);
    const glm::mat4 before = snapshot.instances[7].worldFromObject;
    uint64_t builds = 0, differ = 0;
    for (int frame = 0; frame < 100; ++frame) {
      seeFrom(snapshot, camera(0.3f + 0.05f * static_cast<float>(frame)), at);
      builds += seen.update(snapshot, arena).tlasBuilds;
      differ += snapshot.instances[7].worldFromObject != before;
    }
    EXPECT_GT(differ, 50u) << "this tests nothing";
    EXPECT_FALSE(seen.mayCoincide());
    return builds;
  }
};

TEST_F(Placement, CameraMovesKeepTheTopLevel) {
  std::vector<glm::vec3> inARow, around;
  for (int i = 0; i < 50; ++i) {
    inARow.emplace_back(1.7 * i - 40, 0.3 * i, -7.1 * i);
    around.push_back(0.2f * static_cast<float>(i) *
                     glm::vec3(std::sin(5 * i), std::sin(7 * i), std::cos(3 * i)));
  }
  for (const float distance : {3.0f, 30.0f, 300.0f, 10000.0f})
    for (const auto& at : {inARow, around}) {
      EXPECT_EQ(buildsOf(turnedAt(distance), at), 0u) << distance;
      EXPECT_EQ(buildsOf(lookingFrom(distance), at), 0u) << distance;
    }
}

TEST_F(Placement, SlowMotionIsNotTakenForRounding) {
  std::vector<glm::vec3> at{{0, 0, 0}, {5, 0, 0}};
  auto snapshot = test::makeSnapshot({square, square});
  for (int frame = 0; frame < 2000; ++frame) {  // a tenth of a pixel in all, in steps below rounding
    at[1].x = 5 + 2e-6f * static_cast<float>(frame);
    seeFrom(snapshot, turnedAt(30)(0.1f), at);
    world.update(snapshot, arena);
    const float edge = at[1].x + 1;
    EXPECT_FALSE(hits(edge + 1e-4f, 0)) << frame;
    EXPECT_TRUE(hits(edge - 1e-4f, 0)) << frame;
  }
}

// In a parallel projection the distance of the camera is no measure of what can be seen.
TEST_F(Placement, MotionAcrossTheViewOfADistantCameraIsNotTakenForRounding) {
  const glm::mat4 distant = translation({0, 0, -10000});
  auto snapshot = test::makeSnapshot({square, square});
  for (int frame = 0; frame < 10; ++frame) {
    const float edge = frame % 2 ? 6.001f : 6;
    seeFrom(snapshot, distant, {{0, 0, 0}, {edge - 1, 0, 0}});
    EXPECT_EQ(world.update(snapshot, arena).tlasBuilds, 1u);
    EXPECT_TRUE(hits(edge - 1e-4f, 0)) << frame;
    EXPECT_FALSE(hits(edge + 1e-4f, 0)) << frame;
  }
}

}  // namespace
}  // namespace gluray::accel
