#include "render/local/combine.h"

namespace gluray::render {
namespace {

using scene::BaseFormat;
using scene::Combine;

glm::vec4 sourceOf(const scene::Texture& t, uint8_t source, const CombineInputs& in,
                   const glm::vec4& previous) {
  switch (source) {
    case Combine::texture: return in.texels[t.unit];
    case Combine::constant: return t.envColor;
    case Combine::primary: return in.primary;
    case Combine::previous: return previous;
    default: return in.texels[source - Combine::textureUnit];
  }
}

/// The arguments of one part, each as colour and alpha: the alpha part takes its operands' alpha.
struct Arguments {
  glm::vec4 value[3];
  Arguments(const scene::Texture& t, const Combine::Part& part, const CombineInputs& in,
            const glm::vec4& previous) {
    for (size_t i = 0; i < 3; ++i) {
      const Combine::Argument& a = part.arguments[i];
      const glm::vec4 c = sourceOf(t, a.source, in, previous);
      switch (a.operand) {
        case Combine::color: value[i] = c; break;
        case Combine::oneMinusColor: value[i] = 1.0f - c; break;
        case Combine::alpha: value[i] = glm::vec4(c.a); break;
        case Combine::oneMinusAlpha: value[i] = glm::vec4(1 - c.a); break;
      }
    }
  }
};

glm::vec4 evaluate(Combine::Function function, const glm::vec4 (&a)[3]) {
  switch (function) {
    case Combine::replace: return a[0];
    case Combine::modulate: return a[0] * a[1];
    case Combine::add: return a[0] + a[1];
    case Combine::addSigned: return a[0] + a[1] - 0.5f;
    case Combine::interpolate: return a[0] * a[2] + a[1] * (1.0f - a[2]);
    case Combine::subtract: return a[0] - a[1];
    case Combine::dot3Rgb:
    case Combine::dot3Rgba: return glm::vec4(4 * glm::dot(glm::vec3(a[0]) - 0.5f, glm::vec3(a[1]) - 0.5f));
  }
  return a[0];
}

glm::vec4 combine(const scene::Texture& t, const CombineInputs& in, const glm::vec4& previous) {
  const Combine& c = t.combine;
  const glm::vec4 rgb = evaluate(c.rgb.function, Arguments(t, c.rgb, in, previous).value);
  const glm::vec3 scaled = glm::vec3(rgb) * c.rgb.scale;
  if (c.rgb.function == Combine::dot3Rgba) return {scaled, rgb.a * c.alphaPart.scale};
  const glm::vec4 alpha = evaluate(c.alphaPart.function, Arguments(t, c.alphaPart, in, previous).value);
  return {scaled, alpha.a * c.alphaPart.scale};
}

}  // namespace

glm::vec4 applyEnvironment(const scene::Texture& t, const CombineInputs& in, glm::vec4 previous) {
  using scene::TexEnv;
  if (t.env == TexEnv::combine) return combine(t, in, previous);
  const glm::vec4& texel = in.texels[t.unit];
  const BaseFormat format = t.image->baseFormat;
  const bool hasColor = format != BaseFormat::alpha;
  const bool hasAlpha = format != BaseFormat::luminance && format != BaseFormat::rgb;
  const bool intensity = format == BaseFormat::intensity;
  const glm::vec3 cf(previous), cs(texel), cc(t.envColor);
  const float af = previous.a, as = texel.a;
  // Alpha of modulate, blend and add, unless a row of the tables differs.
  const float modulated = hasAlpha ? af * as : af;
  switch (t.env) {
    case TexEnv::replace: return {hasColor ? cs : cf, hasAlpha ? as : af};
    case TexEnv::decal:
      // Undefined for all but RGB and RGBA (GL 2.1, table 3.22): the incoming colour, as in Mesa.
      if (format == BaseFormat::rgb) return {cs, af};
      return {format == BaseFormat::rgba ? glm::mix(cf, cs, as) : cf, af};
    case TexEnv::blend:
      return {hasColor ? cf * (1.0f - cs) + cc * cs : cf,
              intensity ? af * (1 - as) + t.envColor.a * as : modulated};
    case TexEnv::add: return {hasColor ? cf + cs : cf, intensity ? af + as : modulated};
    default: return {hasColor ? cf * cs : cf, modulated};
  }
}

}  // namespace gluray::render
