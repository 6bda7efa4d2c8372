// The upward axis of a view, found from the program's camera.
#include "gl/views/upward_axes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

scene::Snapshot seenFrom(const glm::dvec3& eye, const glm::dvec3& up, const glm::dvec3& scale = {1, 1, 1}) {
  scene::Snapshot s;
  s.camera.clipFromEye = glm::perspective(0.8, 1.3, 0.1, 100.0);
  s.eyeFromWorld = glm::scale(glm::lookAt(eye, glm::dvec3(0), up), scale);
  return s;
}

TEST(UpwardAxes, AreThoseThatPointMostUpwards) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      glm::dvec3 up(0), eye(3, 4, 5);
      up[axis] = sign;
      EXPECT_EQ(int(UpwardAxes().axisOf({}, seenFrom(eye, up))), axis);
      EXPECT_EQ(int(UpwardAxes().axisOf({}, seenFrom(eye, up, {1, 100, 0.01}))), axis) << "scaled";
    }
}

TEST(UpwardAxes, StayWhileTheCameraTurnsUntilAnotherIsClearlyUp) {
  UpwardAxes axes;
  BatchKey window, other;
  other.viewport = {5, 0, 9, 9};
  const auto tilted = [](double degrees) {  // from y to z
    const double a = glm::radians(degrees);
    return seenFrom({5, 0, 0}, {0, std::cos(a), std::sin(a)});
  };
  EXPECT_EQ(axes.axisOf(window, tilted(0)), LightsUp::y);
  EXPECT_EQ(axes.axisOf(window, tilted(50)), LightsUp::y) << "z is nearer, but not clearly";
  EXPECT_EQ(axes.axisOf(other, tilted(50)), LightsUp::z) << "another view begins with it";
  EXPECT_EQ(axes.axisOf(window, tilted(70)), LightsUp::z);
  EXPECT_EQ(axes.axisOf(window, tilted(40)), LightsUp::z);
  EXPECT_EQ(axes.axisOf(window, tilted(10)), LightsUp::y);
}

}  // namespace
}  // namespace gluray::gl
