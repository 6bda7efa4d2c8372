// How the tests of the twenty habits run a program: by the real OpenGL and through ours, compared.
#pragma once
#include "scenes/stage.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test::twenty_points {

using namespace scenes;

constexpr int kWidth = 240, kHeight = 180;

/// What the program read back on its way.
using Seen = std::vector<float>;
using Program = std::function<void(Gl, Seen&)>;

struct Expected {
  Tolerance tolerance = {};
  float seenTolerance = 1e-4f;
  uint64_t traced = 1;  // draws, at least
};

/// Runs the program both ways and compares pictures, answers and errors; what ours counted.
gl::Statistics expectSame(const Program& program, const Expected& wanted = {});

/// Cleared, with camera, light and material.
void stage(Gl gl);

}  // namespace gluray::test::twenty_points
