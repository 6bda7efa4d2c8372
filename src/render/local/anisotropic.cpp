#include "render/local/anisotropic.h"

#include "render/local/texture_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gluray::render {
namespace {

constexpr int kWeights = 1024;

/// Weights by the squared distance from the centre, which is kWeights - 1 on the ellipse.
const std::array<float, kWeights>& weights() {
  static const std::array<float, kWeights> table = [] {
    std::array<float, kWeights> made{};
    for (size_t i = 0; i < kWeights; ++i)
      made[i] = std::exp(-2 * static_cast<float>(i) / static_cast<float>(kWeights - 1));
    return made;
  }();
  return table;
}

/// The level where the ellipse's shorter axis is about one texel. llvmpipe compares the axes' ratio with the
/// limit in a way that never applies it.
int levelFor(const scene::Texture& t, const Footprint& f) {
  if (t.mipFilter == scene::MipFilter::none) return 0;
  const double x = glm::dot(f.dx, f.dx), y = glm::dot(f.dy, f.dy);
  const double shorter = std::min(x, y);
  if (!(shorter > 0) || !std::isfinite(shorter)) return 0;
  const float lod = limitedLod(t, llvmpipeLod(shorter));
  const float level = t.mipFilter == scene::MipFilter::nearest ? std::floor(lod + 0.5f) : std::floor(lod);
  return static_cast<int>(std::clamp(level, 0.0f, static_cast<float>(t.image->levels() - 1)));
}

/// The ellipse a x^2 + b x y + c y^2 = kWeights - 1 in texels of a level, and half of its bounding box.
struct Ellipse {
  float a, b, c, boxU, boxV;
  Ellipse(const glm::vec2& dx, const glm::vec2& dy) {
    a = dx.y * dx.y + dy.y * dy.y + 1, b = -2 * (dx.x * dx.y + dy.x * dy.y),
    c = dx.x * dx.x + dy.x * dy.x + 1;
    const float f = a * c - b * b / 4, d = 4 * a * c - b * b;
    boxU = 2 / d * std::sqrt(d * c * f), boxV = 2 / d * std::sqrt(a * d * f);
    const float scale = static_cast<float>(kWeights - 1) / f;
    a *= scale, b *= scale, c *= scale;
  }
};

}  // namespace

glm::vec4 sampleAnisotropic(const scene::Texture& t, const Footprint& footprint, glm::vec3 str) {
  const int level = levelFor(t, footprint);
  const scene::TexelGrid& grid = t.image->level(level);
  const float scale = 1 / static_cast<float>(1 << level);
  const glm::vec2 dx = glm::vec2(footprint.dx) * scale, dy = glm::vec2(footprint.dy) * scale;
  // The ellipse is too large to be scanned.
  const float longest = std::max(glm::dot(dx, dx), glm::dot(dy, dy));
  if (!(longest < 1e8f)) return sampleLevel(t, grid, scene::Filter::linear, str);
  const Ellipse e(dx, dy);
  const float u = str.x * static_cast<float>(t.image->width) * scale - 0.5f,
              v = str.y * static_cast<float>(t.image->height) * scale - 0.5f;
  const int u0 = static_cast<int>(std::floor(u - e.boxU)), u1 = static_cast<int>(std::ceil(u + e.boxU));
  const int v0 = static_cast<int>(std::floor(v - e.boxV)), v1 = static_cast<int>(std::ceil(v + e.boxV));
  const float first = static_cast<float>(u0) - u;
  glm::vec4 sum(0);
  float all = 0;
  for (int j = v0; j <= v1; ++j) {
    const float row = static_cast<float>(j) - v;
    float q = (e.c * row + e.b * first) * row + e.a * first * first, dq = e.a * (2 * first + 1) + e.b * row;
    for (int i = u0; i <= u1; ++i, q += dq, dq += 2 * e.a) {
      if (!(q < static_cast<float>(kWeights))) continue;
      const float weight = weights()[static_cast<size_t>(std::max(q, 0.0f))];
      const glm::vec3 at(static_cast<float>(i) / static_cast<float>(grid.width),
                         static_cast<float>(j) / static_cast<float>(grid.height), 0);
      sum += weight * sampleLevel(t, grid, scene::Filter::nearest, at);
      all += weight;
    }
  }
  return all > 0 ? sum / all : sampleLevel(t, grid, scene::Filter::linear, str);
}

}  // namespace gluray::render
