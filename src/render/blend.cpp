#include "render/blend.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::BlendEquation;
using scene::BlendFactor;

glm::vec4 colorOf(uint32_t bits) {
  return glm::vec4(bits & 255, bits >> 8 & 255, bits >> 16 & 255, bits >> 24) / 255.0f;
}

/// Of all four channels, of which alpha's is that of the factor as part of blending alpha.
glm::vec4 factor(BlendFactor f, const glm::vec4& s, const glm::vec4& d, const glm::vec4& constant) {
  const glm::vec4 one(1);
  switch (f) {
    case BlendFactor::zero: return glm::vec4(0);
    case BlendFactor::one: return one;
    case BlendFactor::sourceColor: return s;
    case BlendFactor::oneMinusSourceColor: return one - s;
    case BlendFactor::sourceAlpha: return glm::vec4(s.a);
    case BlendFactor::oneMinusSourceAlpha: return glm::vec4(1 - s.a);
    case BlendFactor::destinationAlpha: return glm::vec4(d.a);
    case BlendFactor::oneMinusDestinationAlpha: return glm::vec4(1 - d.a);
    case BlendFactor::destinationColor: return d;
    case BlendFactor::oneMinusDestinationColor: return one - d;
    case BlendFactor::sourceAlphaSaturate: return {glm::vec3(std::min(s.a, 1 - d.a)), 1};
    case BlendFactor::constantColor: return constant;
    case BlendFactor::oneMinusConstantColor: return one - constant;
    case BlendFactor::constantAlpha: return glm::vec4(constant.a);
    case BlendFactor::oneMinusConstantAlpha: return glm::vec4(1 - constant.a);
  }
  return one;
}

glm::vec4 combined(const scene::Blending::Part& part, const glm::vec4& s, const glm::vec4& d,
                   const glm::vec4& constant) {
  if (part.equation == BlendEquation::min) return glm::min(s, d);
  if (part.equation == BlendEquation::max) return glm::max(s, d);
  const glm::vec4 source = s * factor(part.source, s, d, constant),
                  destination = d * factor(part.destination, s, d, constant);
  switch (part.equation) {
    case BlendEquation::subtract: return source - destination;
    case BlendEquation::reverseSubtract: return destination - source;
    default: return source + destination;
  }
}

}  // namespace

uint32_t blended(const scene::Blending& blending, const scene::ColorWrites& writes, uint32_t source,
                 uint32_t there) {
  const glm::vec4 s = colorOf(source), d = colorOf(there);
  glm::vec4 result = combined(blending.rgb, s, d, blending.constant);
  result.a = blending.alpha == blending.rgb && blending.rgb.source != BlendFactor::sourceAlphaSaturate
                 ? result.a
                 : combined(blending.alpha, s, d, blending.constant).a;
  const bool written[] = {writes.red, writes.green, writes.blue, writes.alpha && blending.hasAlpha};
  uint32_t bits = 0;
  for (int c = 0; c < 4; ++c) {
    const auto byte = static_cast<uint32_t>(std::lround(std::clamp(result[c], 0.0f, 1.0f) * 255));
    bits |= written[c] ? byte << (8 * c) : there & (255u << (8 * c));
  }
  return bits;
}

}  // namespace gluray::render
