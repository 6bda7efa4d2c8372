#include "render/media/medium_lattice.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

float Lattice::at(const glm::vec3& p) const {
  const glm::vec3 u = glm::clamp(p - 0.5f, glm::vec3(0), glm::vec3(size - 1));
  const glm::ivec3 first = glm::min(glm::ivec3(u), glm::max(size - 2, 0)),
                   last = glm::min(first + 1, size - 1);
  const glm::vec3 share = u - glm::vec3(first);
  const auto along = [&](int y, int z) {
    const float* row = &values[index({0, y, z})];
    return glm::mix(row[first.x], row[last.x], share.x);
  };
  return glm::mix(glm::mix(along(first.y, first.z), along(last.y, first.z), share.y),
                  glm::mix(along(first.y, last.z), along(last.y, last.z), share.y), share.z);
}

namespace {

/// The part of 0 .. end in which a ray is inside a box from 0 to `size`; empty: x is not below y.
glm::vec2 inside(const glm::vec3& origin, const glm::vec3& direction, const glm::vec3& size, float end) {
  glm::vec2 part(0, end);
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (origin[axis] < 0 || origin[axis] > size[axis]) return {0, 0};
      continue;
    }
    const float a = -origin[axis] / direction[axis], b = (size[axis] - origin[axis]) / direction[axis];
    part = {std::max(part.x, std::min(a, b)), std::min(part.y, std::max(a, b))};
  }
  return part;
}

constexpr float kOpaque = 12;  // optical depth through which less than 1 of 100,000 passes

}  // namespace

float PlacedLattice::transmittance(const glm::vec3& origin, const glm::vec3& direction, float end) const {
  const glm::vec3 from(latticeFromWorld * glm::vec4(origin, 1)),
      along = glm::mat3(latticeFromWorld) * direction;
  const glm::vec2 part = inside(from, along, glm::vec3(extinction->size), end);
  if (!(part.x < part.y)) return 1;
  const glm::vec3 cells = glm::abs(along) * (part.y - part.x);
  const int count = std::max(1, static_cast<int>(std::ceil(std::max({cells.x, cells.y, cells.z}))));
  const float step = (part.y - part.x) / static_cast<float>(count);
  const float length = step * glm::length(dataFromWorld * direction);
  float depth = 0;
  for (int i = 0; i < count && depth < kOpaque; ++i)
    depth += length * extinction->at(from + along * (part.x + step * (static_cast<float>(i) + 0.5f)));
  return std::exp(-depth);
}

float transmittanceOf(const std::vector<PlacedLattice>& media, const glm::vec3& origin,
                      const glm::vec3& direction, float end) {
  float through = 1;
  for (const PlacedLattice& medium : media) through *= medium.transmittance(origin, direction, end);
  return through;
}

}  // namespace gluray::render
