#include "saved/export/arrays/linear_colors.h"

#include "scene/srgb.h"

#include <array>
#include <cmath>

namespace gluray::saved {
namespace {

using Table = std::array<uint16_t, 256>;

Table linearShorts() {
  Table table{};
  for (size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<uint16_t>(std::lround(65535 * scene::decodedSrgb(static_cast<float>(i) / 255)));
  return table;
}

struct DecodeBytes {
  Table table = linearShorts();
  void operator()(const uint8_t* in, uint16_t* out) const {
    for (int c = 0; c < 3; ++c) out[c] = table[in[c]];
    out[3] = static_cast<uint16_t>(in[3] * 257);
  }
};

struct DecodeFloats {
  void operator()(const glm::vec4* in, glm::vec4* out) const { *out = linearOf(*in); }
};

}  // namespace

glm::vec4 linearOf(const glm::vec4& c) {
  return {scene::decodedSrgb(c.r), scene::decodedSrgb(c.g), scene::decodedSrgb(c.b), c.a};
}

SourcePtr linearColors(const SourcePtr& colors) {
  if (colors->element() == Element::bytes4)
    return changedArray<uint8_t, uint16_t>(colors, Element::shorts4, DecodeBytes());
  return changedArray<glm::vec4, glm::vec4>(colors, Element::float4, DecodeFloats());
}

}  // namespace gluray::saved
