#include "render/texture.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::BaseFormat;
using scene::Filter;
using scene::TexelGrid;
using scene::TextureTarget;
using scene::Wrap;

constexpr float kFarthest = 1 << 30;  // coordinates beyond have no fraction; keeps them within integers

int wholeBelow(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i));
}

// The coordinate within the image after wrapping, GL 2.1, 3.8.7; `size` texels.
float wrapCoordinate(Wrap wrap, float s, int size) {
  if (!std::isfinite(s)) return 0;
  s = std::clamp(s, -kFarthest, kFarthest);
  const float half = 0.5f / static_cast<float>(size);
  switch (wrap) {
    case Wrap::repeat: return s - static_cast<float>(wholeBelow(s));
    case Wrap::clamp: return std::clamp(s, 0.0f, 1.0f);
    case Wrap::clampToEdge: return std::clamp(s, half, 1 - half);
    case Wrap::clampToBorder: return std::clamp(s, -half, 1 + half);
    case Wrap::mirroredRepeat: {
      const int whole = wholeBelow(s);
      const float part = s - static_cast<float>(whole);
      return std::clamp(whole & 1 ? 1 - part : part, half, 1 - half);
    }
    case Wrap::mirrorClamp: return std::min(std::abs(s), 1.0f);
    case Wrap::mirrorClampToEdge: return std::clamp(std::abs(s), half, 1 - half);
    case Wrap::mirrorClampToBorder: return std::min(std::abs(s), 1 + half);
  }
  return s;
}

/// The texels of one axis that a coordinate lies between; -1 is the border.
struct Taps {
  int lower, upper;
  float weight;  // of `upper`
};

Taps tapsOf(Wrap wrap, Filter filter, float s, int size) {
  const float u = wrapCoordinate(wrap, s, size) * static_cast<float>(size);
  const auto within = [&](int i) { return i < 0 || i >= size ? -1 : i; };
  if (filter == Filter::nearest) {
    const int i = wholeBelow(u);
    if (wrap == Wrap::repeat) return {i < size ? i : 0, 0, 0};
    if (wrap == Wrap::clamp || wrap == Wrap::mirrorClamp) return {std::clamp(i, 0, size - 1), 0, 0};
    return {within(i), 0, 0};
  }
  const int i = wholeBelow(u - 0.5f);
  const float weight = u - 0.5f - static_cast<float>(i);
  if (wrap != Wrap::repeat) return {within(i), within(i + 1), weight};
  return {i < 0 ? i + size : i, i + 1 < size ? i + 1 : 0, weight};
}

// The border colour as a texel of the image's base format.
glm::vec4 borderTexel(const scene::Texture& t) {
  const glm::vec4 c = t.borderColor;
  switch (t.image->baseFormat) {
    case BaseFormat::alpha: return {0, 0, 0, c.a};
    case BaseFormat::luminance: return {c.r, c.r, c.r, 1};
    case BaseFormat::luminanceAlpha: return {c.r, c.r, c.r, c.a};
    case BaseFormat::intensity: return {c.r, c.r, c.r, c.r};
    case BaseFormat::rgb: return {c.r, c.g, c.b, 1};
    case BaseFormat::rgba: return c;
  }
  return c;
}

glm::vec4 texelAt(const scene::Texture& t, const TexelGrid& grid, int i, int j, int k) {
  if ((i | j | k) < 0) return borderTexel(t);
  const auto width = static_cast<size_t>(grid.width), height = static_cast<size_t>(grid.height);
  const size_t at =
      (static_cast<size_t>(k) * height + static_cast<size_t>(j)) * width + static_cast<size_t>(i);
  if (!grid.floats.empty()) return grid.floats[at];
  const uint32_t c = grid.texels[at];
  return glm::vec4(c & 255, c >> 8 & 255, c >> 16 & 255, c >> 24) * (1.0f / 255.0f);
}

glm::vec4 sampleSlice(const scene::Texture& t, const TexelGrid& grid, const Taps& s, const Taps& v, int k) {
  const glm::vec4 below =
      glm::mix(texelAt(t, grid, s.lower, v.lower, k), texelAt(t, grid, s.upper, v.lower, k), s.weight);
  if (t.target == TextureTarget::texture1D) return below;
  return glm::mix(
      below, glm::mix(texelAt(t, grid, s.lower, v.upper, k), texelAt(t, grid, s.upper, v.upper, k), s.weight),
      v.weight);
}

}  // namespace

glm::vec4 sampleLevel(const scene::Texture& t, const TexelGrid& grid, Filter filter, glm::vec3 str) {
  Taps r{0, 0, 0};
  if (t.target == TextureTarget::cubeMap) r.lower = static_cast<int>(str.z);
  if (t.target == TextureTarget::texture3D) r = tapsOf(t.wrapR, filter, str.z, grid.depth);
  const Taps s = tapsOf(t.wrapS, filter, str.x, grid.width);
  const Taps v =
      t.target == TextureTarget::texture1D ? Taps{0, 0, 0} : tapsOf(t.wrapT, filter, str.y, grid.height);
  if (filter == Filter::nearest) return texelAt(t, grid, s.lower, v.lower, r.lower);
  const glm::vec4 lower = sampleSlice(t, grid, s, v, r.lower);
  if (t.target != TextureTarget::texture3D) return lower;
  return glm::mix(lower, sampleSlice(t, grid, s, v, r.upper), r.weight);
}

int cubeFace(glm::dvec3 d) {
  const glm::dvec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x >= 0 ? 0 : 1;
  if (a.y >= a.z) return d.y >= 0 ? 2 : 3;
  return d.z >= 0 ? 4 : 5;
}

glm::dvec3 alongFace(int face, glm::dvec3 d) {
  switch (face) {
    case 0: return {-d.z, -d.y, d.x};
    case 1: return {d.z, -d.y, -d.x};
    case 2: return {d.x, d.z, d.y};
    case 3: return {d.x, -d.z, -d.y};
    case 4: return {d.x, -d.y, d.z};
    default: return {-d.x, -d.y, -d.z};
  }
}

glm::dvec2 coordinatesInFace(int face, glm::dvec3 d) {
  const glm::dvec3 along = alongFace(face, d);
  return 0.5 * (glm::dvec2(along) / along.z + 1.0);
}

}  // namespace gluray::render
