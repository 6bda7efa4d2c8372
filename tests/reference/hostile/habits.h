// Runs a program of the habit tests with the real OpenGL and through GLuRay, and compares.
#pragma once
#include "scenes/stage.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test::twenty_points {

using namespace scenes;

constexpr int kWidth = 240, kHeight = 180;

/// Values that the program read back while it ran.
using Seen = std::vector<float>;
using Program = std::function<void(Gl, Seen&)>;

struct Expected {
  Tolerance tolerance = {};
  float seenTolerance = 1e-4f;
  uint64_t traced = 1;  // draws, at least
};

/// Runs the program both ways and compares images, read-back values and errors. Returns GLuRay's counts.
gl::Statistics expectSame(const Program& program, const Expected& wanted = {});

/// Cleared, with camera, light and material.
void stage(Gl gl);

}  // namespace gluray::test::twenty_points
