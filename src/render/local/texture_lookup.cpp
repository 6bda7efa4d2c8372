#include "render/local/texture_lookup.h"

#include "render/local/byte_filter.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::BaseFormat;
using scene::Filter;
using scene::TexelGrid;
using scene::TextureTarget;
using scene::Wrap;

constexpr float kFarthest = 1 << 30;  // larger coordinates have no fraction; clamping keeps them within int

int wholeBelow(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i));
}

// The coordinate after wrapping, for `size` texels: GL 2.1, 3.8.7.
float wrapCoordinate(Wrap wrap, float s, int size) {
  if (!std::isfinite(s)) return 0;
  s = std::clamp(s, -kFarthest, kFarthest);
  const float half = 0.5f / static_cast<float>(size);
  switch (wrap) {
    case Wrap::repeat: break;  // repeatedTaps()
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

/// The two texels of one axis around a coordinate; -1 is the border.
struct Taps {
  int lower, upper;
  float weight;  // of `upper`
};

Taps repeatedTaps(Filter filter, float s, int size) {
  if (!(std::abs(s) < kFarthest)) s = 0;
  const float u = (s - static_cast<float>(wholeBelow(s))) * static_cast<float>(size);
  if (filter == Filter::nearest) {
    const int i = static_cast<int>(u);
    return {i < size ? i : 0, 0, 0};
  }
  const int i = wholeBelow(u - 0.5f);
  return {i < 0 ? i + size : i, i + 1 < size ? i + 1 : 0, u - 0.5f - static_cast<float>(i)};
}

Taps tapsOf(Wrap wrap, Filter filter, float s, int size) {
  if (wrap == Wrap::repeat) return repeatedTaps(filter, s, size);
  const float u = wrapCoordinate(wrap, s, size) * static_cast<float>(size);
  const auto within = [&](int i) { return i < 0 || i >= size ? -1 : i; };
  if (filter == Filter::nearest) {
    const int i = wholeBelow(u);
    if (wrap == Wrap::clamp || wrap == Wrap::mirrorClamp) return {std::clamp(i, 0, size - 1), 0, 0};
    return {within(i), 0, 0};
  }
  const int i = wholeBelow(u - 0.5f);
  const float weight = u - 0.5f - static_cast<float>(i);
  return {within(i), within(i + 1), weight};
}

// The border colour, converted to the image's base format.
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

/// Four channels in one register (a vector extension of GCC and Clang).
using Color = float __attribute__((vector_size(16)));
using Integers = int32_t __attribute__((vector_size(16)));

inline Color colorOf(const glm::vec4& c) { return Color{c.r, c.g, c.b, c.a}; }

/// Reads texels of one level. Eight-bit texels stay in 0 .. 255 until the end.
class TexelReader {
 public:
  TexelReader(const scene::Texture& t, const TexelGrid& grid)
      : texture_(t),
        grid_(grid),
        texels_(grid.texels.data()),
        floats_(grid.floats.empty() ? nullptr : grid.floats.data()),
        width_(static_cast<size_t>(grid.width)) {}

  Color operator()(int i, int j, int k) const {
    if ((i | j | k) < 0) return colorOf(borderTexel(texture_) * (floats_ ? 1.0f : 255.0f));
    const size_t row = static_cast<size_t>(k) * static_cast<size_t>(grid_.height) + static_cast<size_t>(j);
    const size_t at = row * width_ + static_cast<size_t>(i);
    if (floats_) return colorOf(floats_[at]);
    const uint32_t c = texels_[at];
    const auto channel = [&](int shift) { return static_cast<int32_t>(c >> shift & 255); };
    return __builtin_convertvector((Integers{channel(0), channel(8), channel(16), channel(24)}), Color);
  }

  glm::vec4 finished(Color c) const {
    if (!floats_) c *= 1.0f / 255.0f;
    return {c[0], c[1], c[2], c[3]};
  }

 private:
  const scene::Texture& texture_;
  const TexelGrid& grid_;
  const uint32_t* texels_;
  const glm::vec4* floats_;
  size_t width_;
};

inline Color mix(Color a, Color b, float weight) { return a + (b - a) * weight; }

inline Color sampleSlice(const TexelReader& read, bool flat, const Taps& s, const Taps& t, int k) {
  const Color below = mix(read(s.lower, t.lower, k), read(s.upper, t.lower, k), s.weight);
  if (flat) return below;
  return mix(below, mix(read(s.lower, t.upper, k), read(s.upper, t.upper, k), s.weight), t.weight);
}

/// The point of a cube map's face at (sc, tc, ma), relative to the face.
glm::vec3 fromFace(int face, glm::vec3 d) {
  switch (face) {
    case 0: return {d.z, -d.y, -d.x};
    case 1: return {-d.z, -d.y, d.x};
    case 2: return {d.x, d.z, d.y};
    case 3: return {d.x, -d.z, -d.y};
    case 4: return {d.x, -d.y, d.z};
    default: return {-d.x, -d.y, -d.z};
  }
}

/// The texel one step beyond an edge of a face, on the face behind that edge.
Color texelBeyond(const TexelReader& read, int size, int face, int i, int j) {
  const auto centre = [&](int x) { return (2 * static_cast<float>(x) + 1) / static_cast<float>(size) - 1; };
  glm::vec3 at(centre(i), centre(j), 1);
  for (int axis = 0; axis < 2; ++axis)  // folds it over the edge
    if (std::abs(at[axis]) > 1) at.z = 2 - std::abs(at[axis]), at[axis] = at[axis] < 0 ? -1.0f : 1.0f;
  const glm::vec3 direction = fromFace(face, at);
  const int other = cubeFace(direction);
  const glm::vec2 st = coordinatesInFace(other, direction);
  const auto index = [&](float c) {
    return std::clamp(static_cast<int>(c * static_cast<float>(size)), 0, size - 1);
  };
  return read(index(st.x), index(st.y), other);
}

/// Linear filtering across the edges of a cube map. The texel that is missing at a corner is the mean of the
/// other three (OpenGL 4.6, 8.14.1).
Color sampleSeamless(const TexelReader& read, int size, glm::vec3 str) {
  const int face = static_cast<int>(str.z);
  const float u = str.x * static_cast<float>(size) - 0.5f, v = str.y * static_cast<float>(size) - 0.5f;
  const int i = wholeBelow(u), j = wholeBelow(v);
  Color texels[4], sum{};
  int missing = -1;
  for (int k = 0; k < 4; ++k) {
    const int x = i + (k & 1), y = j + (k >> 1);
    const bool outX = x < 0 || x >= size, outY = y < 0 || y >= size;
    if (outX && outY) {
      missing = k;
      continue;
    }
    texels[k] = outX || outY ? texelBeyond(read, size, face, x, y) : read(x, y, face);
    sum += texels[k];
  }
  if (missing >= 0) texels[missing] = sum * (1 / 3.0f);
  const float s = u - static_cast<float>(i), t = v - static_cast<float>(j);
  return mix(mix(texels[0], texels[1], s), mix(texels[2], texels[3], s), t);
}

}  // namespace

glm::vec4 sampleLevel(const scene::Texture& t, const TexelGrid& grid, Filter filter, glm::vec3 str) {
  if (t.seamless && filter == Filter::linear) {
    const TexelReader read(t, grid);
    return read.finished(sampleSeamless(read, grid.width, str));
  }
  if (filter == Filter::linear && isFilteredInBytes(t)) return sampleBytes(t, grid, str);
  Taps r{0, 0, 0};
  if (t.target == TextureTarget::cubeMap) r.lower = static_cast<int>(str.z);
  if (t.target == TextureTarget::texture3D) r = tapsOf(t.wrapR, filter, str.z, grid.depth);
  const Taps s = tapsOf(t.wrapS, filter, str.x, grid.width);
  const Taps v =
      t.target == TextureTarget::texture1D ? Taps{0, 0, 0} : tapsOf(t.wrapT, filter, str.y, grid.height);
  const TexelReader read(t, grid);
  if (filter == Filter::nearest) return read.finished(read(s.lower, v.lower, r.lower));
  const bool flat = t.target == TextureTarget::texture1D;
  const Color lower = sampleSlice(read, flat, s, v, r.lower);
  if (t.target != TextureTarget::texture3D) return read.finished(lower);
  return read.finished(mix(lower, sampleSlice(read, flat, s, v, r.upper), r.weight));
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
