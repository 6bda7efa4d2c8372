#include "render/local/byte_filter.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::TexelGrid;
using scene::TextureTarget;
using scene::Wrap;

constexpr float kMaxPosition = 1 << 30;  // so that coordinates are within int

/// Four channels in one register (a vector extension of GCC and Clang).
using ByteColor = int32_t __attribute__((vector_size(16)));

/// The two texels of one axis around a coordinate.
struct ByteTaps {
  int lower, upper;
  int weight;  // of `upper`, in 0 .. 255 of 256
};

/// Floor and fraction of a position in 1/256 texels, relative to the centre of the first texel.
ByteTaps byteTapsAt(float position) {
  const int at = static_cast<int>(std::nearbyint(std::clamp(position, -kMaxPosition, kMaxPosition))) - 128;
  return {at >> 8, (at >> 8) + 1, at & 255};
}

ByteTaps repeatedByteTaps(float s, int size) {
  const bool powerOfTwo = (size & (size - 1)) == 0;
  if (powerOfTwo) {
    ByteTaps taps = byteTapsAt(s * static_cast<float>(size * 256));
    taps.lower &= size - 1, taps.upper &= size - 1;
    return taps;
  }
  ByteTaps taps = byteTapsAt((s - std::floor(s)) * static_cast<float>(size) * 256);
  taps.lower = taps.lower < 0 ? size - 1 : std::min(taps.lower, size - 1);
  taps.upper = taps.lower == size - 1 ? 0 : taps.lower + 1;
  return taps;
}

ByteTaps byteTapsOf(Wrap wrap, float s, int size) {
  if (!std::isfinite(s)) s = 0;
  if (wrap == Wrap::repeat) return repeatedByteTaps(s, size);
  ByteTaps taps = byteTapsAt(s * static_cast<float>(size * 256));
  taps.lower = std::clamp(taps.lower, 0, size - 1), taps.upper = std::clamp(taps.upper, 0, size - 1);
  return taps;
}

/// Rounds to the nearest integer, halves up.
ByteColor mixed(ByteColor a, ByteColor b, int weight) { return a + (((b - a) * weight + 128) >> 8); }

ByteColor byteTexel(const TexelGrid& grid, int i, int j, int k) {
  const size_t row = static_cast<size_t>(k) * static_cast<size_t>(grid.height) + static_cast<size_t>(j);
  const uint32_t c = grid.texels[row * static_cast<size_t>(grid.width) + static_cast<size_t>(i)];
  const auto channel = [&](int shift) { return static_cast<int32_t>(c >> shift & 255); };
  return ByteColor{channel(0), channel(8), channel(16), channel(24)};
}

ByteColor byteSlice(const TexelGrid& grid, const ByteTaps& s, const ByteTaps& t, int k) {
  const ByteColor below =
      mixed(byteTexel(grid, s.lower, t.lower, k), byteTexel(grid, s.upper, t.lower, k), s.weight);
  if (t.lower == t.upper) return below;
  return mixed(below,
               mixed(byteTexel(grid, s.lower, t.upper, k), byteTexel(grid, s.upper, t.upper, k), s.weight),
               t.weight);
}

glm::vec4 asColor(ByteColor c) { return glm::vec4(c[0], c[1], c[2], c[3]) * (1.0f / 255.0f); }

ByteColor asBytes(const glm::vec4& c) {
  const auto channel = [](float v) { return static_cast<int32_t>(v * 255.0f + 0.5f); };
  return ByteColor{channel(c.r), channel(c.g), channel(c.b), channel(c.a)};
}

}  // namespace

bool isFilteredInBytes(const scene::Texture& t) { return t.byteFilter && t.image->floats.empty(); }

glm::vec4 sampleBytes(const scene::Texture& t, const TexelGrid& grid, glm::vec3 str) {
  const bool cube = t.target == TextureTarget::cubeMap;
  const ByteTaps s = byteTapsOf(cube ? Wrap::clampToEdge : t.wrapS, str.x, grid.width);
  const ByteTaps v = t.target == TextureTarget::texture1D
                         ? ByteTaps{0, 0, 0}
                         : byteTapsOf(cube ? Wrap::clampToEdge : t.wrapT, str.y, grid.height);
  if (t.target != TextureTarget::texture3D)
    return asColor(byteSlice(grid, s, v, cube ? static_cast<int>(str.z) : 0));
  const ByteTaps r = byteTapsOf(t.wrapR, str.z, grid.depth);
  return asColor(mixed(byteSlice(grid, s, v, r.lower), byteSlice(grid, s, v, r.upper), r.weight));
}

glm::vec4 mixBytes(const glm::vec4& a, const glm::vec4& b, float weight) {
  return asColor(mixed(asBytes(a), asBytes(b), static_cast<int>(weight * 256)));
}

}  // namespace gluray::render
