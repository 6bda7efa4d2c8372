// Models for the scenes: closed and open surfaces with normals, texture coordinates and colours.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::scenes {

/// Indexed triangles, counter-clockwise seen from outside.
struct Model {
  std::vector<float> positions;   // x, y, z
  std::vector<float> normals;     // unit length
  std::vector<float> texcoords;   // s, t
  std::vector<uint8_t> colors;    // r, g, b, a; opaque
  std::vector<uint32_t> indices;  // three a triangle
  uint32_t vertexCount() const { return static_cast<uint32_t>(positions.size() / 3); }
};

/// Radius 1 about the origin; 2 * segments * (rings - 1) triangles.
Model sphere(int rings, int segments);
/// Ring of radius `major` in the xy plane, tube of radius `minor`; 2 * around * across triangles.
Model torus(float major, float minor, int around, int across);
/// A vase about the y axis, from y = -1 to 1: a surface of revolution, open at the top.
Model vase(int around, int along);
/// A wavy sheet over [-1, 1]^2, z = 0.2 sin(4x) cos(3y); 2 n^2 triangles.
Model sheet(int n);

}  // namespace gluray::scenes
