// Meshes, views and depth images for tests of visibility.
#pragma once
#include "gl/culled/clusters/clusters.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace gluray::gl::culling_test {

inline constexpr int kWidth = 90, kHeight = 70;

struct TestMesh {
  std::vector<glm::vec3> points;
  std::vector<uint32_t> indices;
  Primitives primitives() const {
    Primitives p;
    p.positions = reinterpret_cast<const std::byte*>(points.data()), p.stride = sizeof(glm::vec3);
    p.indices = indices.data(), p.count = static_cast<uint32_t>(indices.size() / 3);
    return p;
  }
};

/// A wavy sheet of n x rows squares. `shuffled`: its triangles are in random order.
inline TestMesh sheet(int n, int rows, bool shuffled, unsigned seed) {
  std::mt19937 random(seed);
  TestMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= n; ++i) {
      const float x = 2.0f * static_cast<float>(i) / static_cast<float>(n) - 1,
                  y = 2.0f * static_cast<float>(j) / static_cast<float>(rows) - 1;
      mesh.points.emplace_back(x, y, 0.3f * std::sin(7 * x) * std::cos(5 * y));
    }
  std::vector<std::array<uint32_t, 3>> triangles;
  const auto row = static_cast<uint32_t>(n + 1);
  for (uint32_t j = 0; j < static_cast<uint32_t>(rows); ++j)
    for (uint32_t i = 0; i < static_cast<uint32_t>(n); ++i) {
      const uint32_t a = j * row + i;
      triangles.push_back({a, a + 1, a + row}), triangles.push_back({a + row, a + 1, a + row + 1});
    }
  if (shuffled) std::ranges::shuffle(triangles, random);
  for (const auto& t : triangles) mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
  return mesh;
}

inline ClipMatrix clipBy(const glm::dmat4& m) {
  ClipMatrix matrix{m, m};
  for (int c = 0; c < 4; ++c) matrix.magnitudes[c] = glm::abs(m[c]);
  return matrix;
}

inline WindowMapping window() { return {glm::dvec4(0, 0, kWidth, kHeight), 0, 1}; }

inline bool isSet(const std::vector<uint64_t>& bits, uint32_t i) { return bits[i / 64] >> (i & 63) & 1; }

inline glm::dmat4 randomView(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  const glm::dmat4 clip = random() % 4 == 0
                              ? glm::ortho(-1.5, 1.5, -1.5, 1.5, 0.5, 6.0)
                              : glm::perspective(0.5 + 0.4 * (number(random) + 1), 1.3, 0.05, 9.0);
  const glm::dvec3 eye(1.8 * number(random), 1.8 * number(random), 0.3 + 1.5 * (number(random) + 1));
  glm::dmat4 view =
      glm::lookAt(eye, glm::dvec3(0.2 * number(random)), glm::normalize(glm::dvec3(number(random), 1, 0.3)));
  if (random() % 5 == 0) view = view * glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 2));
  return clip * view;
}

/// An image of depths with a near patch, a far one and a slope.
inline std::vector<float> depthImage(std::mt19937& random) {
  std::uniform_real_distribution<float> depth(0.2f, 1);
  const float base = depth(random), slope = 0.5f * (depth(random) - 0.5f), patch = depth(random);
  std::vector<float> all(static_cast<size_t>(kWidth) * kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x > 20 && x < 60 && y > 10 && y < 50;
      const float value = inside ? patch : base + slope * static_cast<float>(x) / kWidth;
      all[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)] = std::clamp(value, 0.0f, 1.0f);
    }
  return all;
}

/// A triangle in front of the viewer, in pixels and depth.
struct WindowTriangle {
  explicit WindowTriangle(const std::array<glm::dvec4, 3>& clip) {
    for (size_t i = 0; i < 3; ++i)
      corners[i] = (glm::dvec3(clip[i]) / clip[i].w + 1.0) / 2.0 * glm::dvec3(kWidth, kHeight, 1);
  }
  /// Depth at a place in a pixel; nullopt if the triangle does not cover it.
  std::optional<double> depthAt(int x, int y, glm::dvec2 place = glm::dvec2(0.5)) const {
    const glm::dvec3 &a = corners[0], &b = corners[1], &c = corners[2];
    const glm::dvec2 p = glm::dvec2(x, y) + place;
    const auto area = [](const glm::dvec2& u, const glm::dvec2& v, const glm::dvec2& w) {
      return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
    };
    const double all = area(a, b, c);
    const double s = area(p, b, c) / all, t = area(a, p, c) / all, u = 1 - s - t;
    if (!(s >= 0 && t >= 0 && u >= 0)) return std::nullopt;
    return s * a.z + t * b.z + u * c.z;
  }
  std::array<glm::dvec3, 3> corners;
};

/// Expects all pixels of the triangle to be farther than the image, and returns their number.
inline uint64_t expectBehind(const WindowTriangle& triangle, const std::vector<float>& depths) {
  const auto& c = triangle.corners;
  glm::dvec2 lower(c[0]), upper(c[0]);
  for (const glm::dvec3& corner : c)
    lower = glm::min(lower, glm::dvec2(corner)), upper = glm::max(upper, glm::dvec2(corner));
  uint64_t pixels = 0;
  for (int y = static_cast<int>(std::max(lower.y, 0.0)); y < kHeight && y <= upper.y; ++y)
    for (int x = static_cast<int>(std::max(lower.x, 0.0)); x < kWidth && x <= upper.x; ++x) {
      const std::optional<double> depth = triangle.depthAt(x, y);
      if (!depth || *depth < 0 || *depth > 1) continue;
      EXPECT_GT(*depth, double{depths[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)]});
      ++pixels;
    }
  return pixels;
}

}  // namespace gluray::gl::culling_test
