#include "tests/fuzz/scenes/shape.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <cmath>

namespace gluray::fuzz {
namespace {

constexpr float kPi = 3.14159265f;

/// The point of the surface at (u, v), both from 0 to 1.
glm::vec3 pointOf(uint32_t kind, float u, float v, float waves) {
  const float a = 2 * kPi * u, b = kPi * (v - 0.5f);
  switch (kind) {
    case 0: return {2 * u - 1, 2 * v - 1, 0.3f * std::sin(waves * u) * std::cos(waves * v)};
    case 1: return {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
    default: {
      const float c = 2 * kPi * v, r = 0.7f + 0.3f * std::cos(c);
      return {r * std::cos(a), r * std::sin(a), 0.3f * std::sin(c)};
    }
  }
}

glm::vec3 normalOf(uint32_t kind, float u, float v, float waves) {
  constexpr float kStep = 1e-3f;
  if (kind == 1) return pointOf(1, u, v, waves);
  const glm::vec3 across = pointOf(kind, u + kStep, v, waves) - pointOf(kind, u - kStep, v, waves);
  const glm::vec3 up = pointOf(kind, u, v + kStep, waves) - pointOf(kind, u, v - kStep, waves);
  return glm::normalize(glm::cross(across, up));
}

}  // namespace

Shape makeShape(Dice& dice) {
  Shape shape;
  shape.columns = 4 + dice.below(20), shape.rows = 4 + dice.below(12);
  shape.colors = dice.chance(40);
  const uint32_t kind = dice.below(3);
  const float waves = dice.real(0, 6);
  const auto first = dice.color(), last = dice.color();
  for (uint32_t j = 0; j < shape.rows; ++j)
    for (uint32_t i = 0; i < shape.columns; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(shape.columns - 1),
                  v = static_cast<float>(j) / static_cast<float>(shape.rows - 1);
      const glm::vec3 p = pointOf(kind, u, v, waves), n = normalOf(kind, u, v, waves);
      Corner corner{{p.x, p.y, p.z}, {n.x, n.y, n.z}, {}, {2 * u, 2 * v}};
      for (size_t k = 0; k < 4; ++k) corner.color[k] = first[k] + (last[k] - first[k]) * u;
      shape.corners.push_back(corner);
    }
  return shape;
}

namespace {

void sendCorner(const gl::RealGl& gl, const Shape& shape, uint32_t number) {
  const Corner& c = shape.corners[number];
  gl.Normal3fv(c.normal), gl.TexCoord2fv(c.texcoord);
  if (shape.colors) gl.Color4fv(c.color);
  gl.Vertex3fv(c.position);
}

std::vector<GLuint> trianglesOf(const Shape& shape) {
  std::vector<GLuint> numbers;
  for (uint32_t j = 0; j + 1 < shape.rows; ++j)
    for (uint32_t i = 0; i + 1 < shape.columns; ++i) {
      const uint32_t a = j * shape.columns + i, b = a + shape.columns;
      numbers.insert(numbers.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  return numbers;
}

void setArrays(const gl::RealGl& gl, const Shape& shape, const std::vector<Corner>& corners) {
  constexpr GLsizei kStride = sizeof(Corner);
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, kStride, corners[0].position);
  gl.EnableClientState(GL_NORMAL_ARRAY), gl.NormalPointer(GL_FLOAT, kStride, corners[0].normal);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY), gl.TexCoordPointer(2, GL_FLOAT, kStride, corners[0].texcoord);
  if (shape.colors)
    gl.EnableClientState(GL_COLOR_ARRAY), gl.ColorPointer(4, GL_FLOAT, kStride, corners[0].color);
}

void dropArrays(const gl::RealGl& gl) {
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
    gl.DisableClientState(array);
}

}  // namespace

void sendShape(const gl::RealGl& gl, const Shape& shape, Sending how, Dice& dice) {
  const std::vector<GLuint> numbers = trianglesOf(shape);
  const auto count = static_cast<GLsizei>(numbers.size());
  if (how == Sending::begin) {
    gl.Begin(GL_TRIANGLES);
    for (const GLuint number : numbers) sendCorner(gl, shape, number);
    gl.End();
  } else if (how == Sending::strips) {
    for (uint32_t j = 0; j + 1 < shape.rows; ++j) {
      gl.Begin(GL_TRIANGLE_STRIP);
      for (uint32_t i = 0; i < shape.columns; ++i)
        sendCorner(gl, shape, j * shape.columns + i), sendCorner(gl, shape, (j + 1) * shape.columns + i);
      gl.End();
    }
  } else if (how == Sending::elements) {
    setArrays(gl, shape, shape.corners);
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, numbers.data());
    dropArrays(gl);
  } else {
    std::vector<Corner> corners;
    for (const GLuint number : numbers) corners.push_back(shape.corners[number]);
    setArrays(gl, shape, corners);
    gl.DrawArrays(GL_TRIANGLES, 0, count);
    dropArrays(gl);
  }
  // Draws from arrays leave attributes that had arrays undefined. Mesa does not store what is set after them
  // until it is asked for it (avoided.md).
  const auto color = dice.color();
  GLfloat asked[4];
  gl.Color4fv(color.data()), gl.Normal3f(0, 0, 1), gl.TexCoord2f(0, 0);
  gl.GetFloatv(GL_CURRENT_COLOR, asked);
}

}  // namespace gluray::fuzz
