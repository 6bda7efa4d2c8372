// Bugs that the fuzzer found, reduced to calls after which a program asks something.
#pragma once
#include "gl/real/real.h"

#include <array>
#include <span>
#include <vector>

namespace gluray::test {

using Gl = const gl::RealGl&;

/// Errors and current values that a program can query.
using Answers = std::vector<float>;

struct Found {
  const char* name;
  void (*calls)(Gl gl, Answers& answers);
};

/// Adds glGetError().
inline void error(Gl gl, Answers& answers) { answers.push_back(static_cast<float>(gl.GetError())); }
/// Adds four components of a state.
inline void four(Gl gl, GLenum name, Answers& answers) {
  std::array<float, 4> v{};
  gl.GetFloatv(name, v.data());
  answers.insert(answers.end(), v.begin(), v.end());
}
inline constexpr GLfloat kValues[64] = {0.5f, 0.25f, -0.5f, 1,    0.75f, 0.1f,
                                        0.2f, 0.3f,  -0.7f, 0.6f, 0.4f,  0.9f};

/// Colours and materials.
std::span<const Found> foundMaterials();
/// What lists leave.
std::span<const Found> foundLists();

}  // namespace gluray::test
