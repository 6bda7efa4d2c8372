#include "scenes/shapes.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <functional>

namespace gluray::scenes {
namespace {

constexpr float kTurn = glm::two_pi<float>();

/// A surface over (u, v) in [0, 1]^2, columns x rows cells. The normal points along dP/du x dP/dv.
Model parametric(int columns, int rows, const std::function<glm::vec3(float, float)>& point) {
  Model m;
  constexpr float h = 1e-3f;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) {
      const float u = static_cast<float>(c) / static_cast<float>(columns);
      const float v = static_cast<float>(r) / static_cast<float>(rows);
      const glm::vec3 p = point(u, v);
      const float inV = std::min(std::max(v, 2 * h), 1 - 2 * h);  // poles have no derivative of their own
      const glm::vec3 n = glm::normalize(
          glm::cross(point(u + h, inV) - point(u - h, inV), point(u, inV + h) - point(u, inV - h)));
      m.positions.insert(m.positions.end(), {p.x, p.y, p.z});
      m.normals.insert(m.normals.end(), {n.x, n.y, n.z});
      m.texcoords.insert(m.texcoords.end(), {u, v});
      const glm::vec3 color =
          0.5f + 0.5f * glm::vec3(std::cos(kTurn * u), std::sin(kTurn * (u + v)), std::cos(kTurn * v * 2));
      for (int k = 0; k < 3; ++k) m.colors.push_back(static_cast<uint8_t>(std::lround(color[k] * 255)));
      m.colors.push_back(255);
    }
  const auto at = [columns](int c, int r) { return static_cast<uint32_t>(r * (columns + 1) + c); };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      for (uint32_t i : {at(c, r), at(c + 1, r), at(c + 1, r + 1), at(c, r), at(c + 1, r + 1), at(c, r + 1)})
        m.indices.push_back(i);
  return m;
}

/// A curve (radius, height) turned about the y axis.
Model revolution(int around, int along, const std::function<glm::vec2(float)>& profile) {
  return parametric(around, along, [&](float u, float v) {
    const glm::vec2 p = profile(v);
    return glm::vec3(p.x * std::sin(kTurn * u), p.y, p.x * std::cos(kTurn * u));
  });
}

}  // namespace

Model sphere(int rings, int segments) {
  return revolution(segments, rings, [](float v) {
    const float angle = glm::pi<float>() * (v - 0.5f);
    return glm::vec2(std::cos(angle), std::sin(angle));
  });
}

Model torus(float major, float minor, int around, int across) {
  return parametric(around, across, [=](float u, float v) {
    const float r = major + minor * std::cos(kTurn * v);
    return glm::vec3(r * std::cos(kTurn * u), r * std::sin(kTurn * u), minor * std::sin(kTurn * v));
  });
}

Model vase(int around, int along) {
  return revolution(around, along, [](float v) {
    return glm::vec2(0.15f + 0.55f * std::sin(2.6f * v + 0.2f) * (0.8f + 0.3f * std::cos(7 * v)), 2 * v - 1);
  });
}

Model sheet(int n) {
  return parametric(n, n, [](float u, float v) {
    const float x = 2 * u - 1, y = 2 * v - 1;
    return glm::vec3(x, y, 0.2f * std::sin(4 * x) * std::cos(3 * y));
  });
}

}  // namespace gluray::scenes
