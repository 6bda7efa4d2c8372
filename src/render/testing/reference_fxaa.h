// Scalar reference implementation of FXAA, as in VTK's shader program, for tests of the vectorised one.
#pragma once
#include "scene/fxaa.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gluray::render {

/// Rounds a non-negative number to nearest, halves up.
inline uint32_t rounded(float v) {
  const auto whole = static_cast<uint32_t>(v);
  return v - static_cast<float>(whole) >= 0.5f ? whole + 1 : whole;
}

/// Filters pixel by pixel. Clamps pixels beyond the border to it.
class ReferenceFxaa {
 public:
  ReferenceFxaa(const scene::Fxaa& settings, const uint32_t* in, int width, int height)
      : settings_(settings), in_(in), width_(width), height_(height) {}

  /// The pixel's new colour.
  uint32_t at(int x, int y) const {
    const float c = lum(x, y), n = lum(x, y - 1), s = lum(x, y + 1), w = lum(x - 1, y), e = lum(x + 1, y);
    const float least = std::min({c, n, s, w, e}), most = std::max({c, n, s, w, e}), range = most - least;
    if (range < std::max(settings_.hardContrast, settings_.relativeContrast * most)) return pixel(x, y);
    const float ne = lum(x + 1, y - 1), se = lum(x + 1, y + 1), nw = lum(x - 1, y - 1),
                sw = lum(x - 1, y + 1);
    const float ns = n + s, we = w + e, nwne = nw + ne, swse = sw + se, nwsw = nw + sw, nese = ne + se;
    const float blend = subpixelBlend(c, ns + we, range);
    const float rows[3] = {std::abs(-2 * n + nwne), std::abs(-2 * c + we), std::abs(-2 * s + swse)};
    const float columns[3] = {std::abs(-2 * w + nwsw), std::abs(-2 * c + ns), std::abs(-2 * e + nese)};
    const float vertical = ((2 * rows[1] + rows[0]) + rows[2]) / 12;
    const float horizontal = ((2 * columns[1] + columns[0]) + columns[2]) / 12;
    const bool alongX = horizontal >= vertical;
    const float one = alongX ? n : w, other = alongX ? s : e;
    const bool towardsOne = std::abs(c - one) >= std::abs(c - other);
    const glm::vec3 edge = alongEdge(x, y, c, towardsOne ? one : other, alongX, towardsOne ? -1 : 1);
    const glm::vec3 result = blend == 0 ? edge : glm::mix(edge, mean3x3(x, y), blend);
    const glm::vec3 bytes = glm::clamp(result, 0.0f, 1.0f) * 255.0f;
    return rounded(bytes.r) | rounded(bytes.g) << 8 | rounded(bytes.b) << 16 | (pixel(x, y) & 0xFF000000u);
  }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(std::clamp(y, 0, height_ - 1)) * static_cast<size_t>(width_) +
           static_cast<size_t>(std::clamp(x, 0, width_ - 1));
  }
  float lum(int x, int y) const {
    const uint32_t p = pixel(x, y);
    const auto channel = [](uint32_t v) { return static_cast<float>(v & 255) * (1.0f / 255); };
    return (channel(p >> 16) * 0.114f + channel(p >> 8) * 0.587f) + channel(p) * 0.299f;
  }
  uint32_t pixel(int x, int y) const { return in_[index(x, y)]; }
  glm::vec3 rgb(int x, int y) const {
    const uint32_t p = pixel(x, y);
    return glm::vec3(p & 255, p >> 8 & 255, p >> 16 & 255) * (1.0f / 255);
  }
  glm::vec3 mean3x3(int x, int y) const {
    glm::vec3 sum(0);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) sum += rgb(x + dx, y + dy);
    return sum * (1.0f / 9);
  }
  float subpixelBlend(float c, float neighbours, float range) const {
    const float contrast = std::abs(0.25f * neighbours - c) / range;
    const float blend = std::max(0.0f, contrast - settings_.subpixelContrast);
    return std::min(settings_.subpixelBlendLimit, blend * (1 / (1 - settings_.subpixelContrast)));
  }

  /// End of an edge in one direction: distance in pixels, and luminosity there on the pixel's side.
  struct End {
    int distance = 1;
    float luminosity = 0;
  };
  End follow(int x, int y, int dx, int dy, int sideX, int sideY, float c, float across) const {
    End end;
    for (int i = 0; i < settings_.endpointSearchIterations; ++i, ++end.distance) {
      const int px = x + dx * end.distance, py = y + dy * end.distance;
      const float there = lum(px + sideX, py + sideY);
      end.luminosity = lum(px, py);
      if (std::abs(there - across) > std::abs(there - c) ||
          std::abs(end.luminosity - c) > std::abs(end.luminosity - across))
        break;
    }
    return end;
  }

  /// Whether the first of two ends is nearer. The program compares texture coordinates that it accumulated in
  /// steps, so its float rounding decides between equal distances.
  static bool isNearer(int at, int size, int before, int after) {
    if (before != after) return before < after;
    const float step = 1.0f / static_cast<float>(size), place = (static_cast<float>(at) + 0.5f) * step;
    float n = place - step, p = place + step;
    for (int i = 1; i < before; ++i) n -= step;
    for (int i = 1; i < after; ++i) p += step;
    return place - n < p - place;
  }

  /// Blends the pixel's colour with the one across the edge.
  glm::vec3 alongEdge(int x, int y, float c, float across, bool alongX, int side) const {
    const int dx = alongX ? 1 : 0, dy = alongX ? 0 : 1, sideX = alongX ? 0 : side, sideY = alongX ? side : 0;
    const End n = follow(x, y, -dx, -dy, sideX, sideY, c, across),
              p = follow(x, y, dx, dy, sideX, sideY, c, across);
    const bool nIsNearest =
        alongX ? isNearer(x, width_, n.distance, p.distance) : isNearer(y, height_, n.distance, p.distance);
    const End& nearest = nIsNearest ? n : p;
    const glm::vec3 here = rgb(x, y);
    if (!(std::abs(nearest.luminosity - across) < std::abs(nearest.luminosity - c))) return here;
    const float offset =
        0.5f - static_cast<float>(nearest.distance) / static_cast<float>(n.distance + p.distance);
    return glm::mix(here, rgb(x + sideX, y + sideY), offset);
  }

  const scene::Fxaa& settings_;
  const uint32_t* in_;
  int width_, height_;
};

}  // namespace gluray::render
