#include "tests/fuzz/scenes/shape.h"

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
    case 2: return {2 * u - 1, 2 * v - 1, 0.1f};
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
  // Draws of few vertices join runs of glBegin.
  const bool small = dice.chance(40);
  shape.columns = small ? 2 + dice.below(4) : 4 + dice.below(20);
  shape.rows = small ? 2 + dice.below(4) : 4 + dice.below(12);
  const uint32_t kind = dice.below(4);
  // Of fewer corners both sides of balls and rings would coincide.
  if (kind == 1 || kind == 3) shape.columns += 3, shape.rows += 3;
  const float waves = dice.real(0, 6);
  const auto first = dice.color(), last = dice.color();
  for (uint32_t j = 0; j < shape.rows; ++j)
    for (uint32_t i = 0; i < shape.columns; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(shape.columns - 1),
                  v = static_cast<float>(j) / static_cast<float>(shape.rows - 1);
      const glm::vec3 p = pointOf(kind, u, v, waves), n = normalOf(kind, u, v, waves);
      // No whole numbers of texels, where rounding would decide.
      Corner corner{{p.x, p.y, p.z}, {n.x, n.y, n.z}, {}, {0.07f + 1.91f * u, 0.06f + 1.83f * v}};
      for (size_t k = 0; k < 4; ++k) corner.color[k] = first[k] + (last[k] - first[k]) * u;
      shape.corners.push_back(corner);
    }
  return shape;
}

Attributes makeAttributes(Dice& dice) {
  const bool normals = dice.chance(85), colors = dice.chance(40), texcoords = dice.chance(60);
  return {normals, colors, texcoords};
}

std::vector<uint32_t> trianglesOf(const Shape& shape) {
  std::vector<uint32_t> numbers;
  for (uint32_t j = 0; j + 1 < shape.rows; ++j)
    for (uint32_t i = 0; i + 1 < shape.columns; ++i) {
      const uint32_t a = j * shape.columns + i, b = a + shape.columns;
      numbers.insert(numbers.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  return numbers;
}

}  // namespace gluray::fuzz
