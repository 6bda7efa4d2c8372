// The shapes of random scenes: wavy patches, balls and rings, and the ways of sending them.
#pragma once
#include "gl/real/real.h"
#include "tests/fuzz/scenes/dice.h"

#include <cstdint>
#include <vector>

namespace gluray::fuzz {

struct Corner {
  float position[3], normal[3], color[4], texcoord[2];
};

/// A grid of `columns` times `rows` corners.
struct Shape {
  uint32_t columns = 0, rows = 0;
  std::vector<Corner> corners;
  bool colors = false;  // whether colours are sent
};

Shape makeShape(Dice& dice);

enum class Sending { begin, strips, arrays, elements };

/// Sends triangles, not quads, which each OpenGL may split differently.
void sendShape(const gl::RealGl& gl, const Shape& shape, Sending how, Dice& dice);

}  // namespace gluray::fuzz
