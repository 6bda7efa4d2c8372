// Random values of scenes.
#pragma once
#include "tests/fuzz/random.h"

#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <initializer_list>

namespace gluray::fuzz {

class Dice {
 public:
  explicit Dice(uint64_t seed) : random_(seed) {}
  uint32_t below(uint32_t n) { return random_.below(n); }
  bool chance(uint32_t percent) { return random_.chance(percent); }
  float real(float least, float most) {
    return least + (most - least) * static_cast<float>(random_.below(1 << 16)) / 65535.0f;
  }
  GLenum pick(std::initializer_list<GLenum> choices) {
    return choices.begin()[random_.below(static_cast<uint32_t>(choices.size()))];
  }
  /// Opaque three times out of four.
  std::array<GLfloat, 4> color() {
    std::array<GLfloat, 4> c{};
    for (int i = 0; i < 3; ++i) c[static_cast<size_t>(i)] = real(0, 1);
    c[3] = chance(75) ? 1.0f : real(0.2f, 0.9f);
    return c;
  }

 private:
  Random random_;
};

}  // namespace gluray::fuzz
