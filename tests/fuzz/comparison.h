// Finds the first difference between a stream's results by the real OpenGL and through GLuRay.
#pragma once
#include "tests/fuzz/player.h"
#include "tests/support/drawn_image.h"
#include "tests/support/gl_state.h"

#include <string>
#include <vector>

namespace gluray::fuzz {

struct Outcome {
  std::string what;  // empty: no difference
  size_t call = 0;   // index of the call where they differ
};

/// All recorded results of a stream.
struct Record {
  std::vector<Answer> answers;
  test::GlState state;
  test::DrawnImage image;
};

Outcome compareAnswers(const std::vector<Answer>& expected, const std::vector<Answer>& got);
Outcome compareState(const test::GlState& expected, test::GlState got);
Outcome compareImages(const test::DrawnImage& expected, const test::DrawnImage& got);

}  // namespace gluray::fuzz
