// The shapes of random scenes: wavy patches, balls and rings.
#pragma once
#include "tests/fuzz/scenes/dice.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gluray::fuzz {

struct Corner {
  std::array<float, 3> position, normal;
  std::array<float, 4> color;
  std::array<float, 2> texcoord;
};

/// A grid of `columns` times `rows` corners.
struct Shape {
  uint32_t columns = 0, rows = 0;
  std::vector<Corner> corners;
};

/// Which attributes the vertices of a shape get.
struct Attributes {
  bool normals = true, colors = false, texcoords = true;
};

Shape makeShape(Dice& dice);
Attributes makeAttributes(Dice& dice);

/// Corner numbers of its triangles: quads, which each OpenGL may split differently, are avoided.
std::vector<uint32_t> trianglesOf(const Shape& shape);

}  // namespace gluray::fuzz
