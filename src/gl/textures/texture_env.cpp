#include "gl/textures/texture_env.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <optional>

namespace gluray::gl {
namespace {

using scene::Combine;
using scene::TexEnv;
using scene::TexGen;

GLint environment(const RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetTexEnviv(GL_TEXTURE_ENV, name, &value);
  return value;
}

bool toFunction(GLint name, Combine::Function& function) {
  switch (name) {
    case GL_REPLACE: function = Combine::replace; return true;
    case GL_MODULATE: function = Combine::modulate; return true;
    case GL_ADD: function = Combine::add; return true;
    case GL_ADD_SIGNED: function = Combine::addSigned; return true;
    case GL_INTERPOLATE: function = Combine::interpolate; return true;
    case GL_SUBTRACT: function = Combine::subtract; return true;
    case GL_DOT3_RGB: function = Combine::dot3Rgb; return true;
    case GL_DOT3_RGBA: function = Combine::dot3Rgba; return true;
    default: return false;
  }
}

bool toArgument(GLint source, GLint operand, Combine::Argument& argument) {
  switch (source) {
    case GL_TEXTURE: argument.source = Combine::texture; break;
    case GL_CONSTANT: argument.source = Combine::constant; break;
    case GL_PRIMARY_COLOR: argument.source = Combine::primary; break;
    case GL_PREVIOUS: argument.source = Combine::previous; break;
    default:
      if (source < GL_TEXTURE0 || source >= GL_TEXTURE0 + scene::kTextureUnits) return false;
      argument.source = static_cast<uint8_t>(Combine::textureUnit + (source - GL_TEXTURE0));
  }
  switch (operand) {
    case GL_SRC_COLOR: argument.operand = Combine::color; return true;
    case GL_ONE_MINUS_SRC_COLOR: argument.operand = Combine::oneMinusColor; return true;
    case GL_SRC_ALPHA: argument.operand = Combine::alpha; return true;
    case GL_ONE_MINUS_SRC_ALPHA: argument.operand = Combine::oneMinusAlpha; return true;
    default: return false;
  }
}

/// Number of arguments of the function.
size_t argumentsOf(Combine::Function function) {
  return function == Combine::replace ? 1 : function == Combine::interpolate ? 3 : 2;
}

bool readPart(const RealGl& real, GLenum function, GLenum source, GLenum operand, GLenum scale,
              Combine::Part& part) {
  if (!toFunction(environment(real, function), part.function)) return false;
  for (size_t i = 0; i < argumentsOf(part.function); ++i) {
    const auto n = static_cast<GLenum>(i);
    if (!toArgument(environment(real, source + n), environment(real, operand + n), part.arguments[i]))
      return false;
  }
  real.GetTexEnvfv(GL_TEXTURE_ENV, scale, &part.scale);
  return true;
}

std::optional<TexEnv> toEnv(GLint mode) {
  switch (mode) {
    case GL_MODULATE: return TexEnv::modulate;
    case GL_REPLACE: return TexEnv::replace;
    case GL_DECAL: return TexEnv::decal;
    case GL_BLEND: return TexEnv::blend;
    case GL_ADD: return TexEnv::add;
    case GL_COMBINE: return TexEnv::combine;
    default: return std::nullopt;
  }
}

std::optional<TexGen::Mode> toMode(GLint mode) {
  switch (mode) {
    case GL_OBJECT_LINEAR: return TexGen::objectLinear;
    case GL_EYE_LINEAR: return TexGen::eyeLinear;
    case GL_SPHERE_MAP: return TexGen::sphereMap;
    case GL_NORMAL_MAP: return TexGen::normalMap;
    case GL_REFLECTION_MAP: return TexGen::reflectionMap;
    default: return std::nullopt;
  }
}

/// Whether sampling the texture gives alpha 1 everywhere. Coordinates outside the image may sample its
/// border.
bool isOpaque(const scene::Texture& t) {
  using scene::BaseFormat;
  using scene::Wrap;
  const bool linear = t.magFilter == scene::Filter::linear || t.minFilter == scene::Filter::linear;
  const auto reaches = [&](Wrap wrap) {
    return wrap == Wrap::clampToBorder || wrap == Wrap::mirrorClampToBorder ||
           (linear && (wrap == Wrap::clamp || wrap == Wrap::mirrorClamp));
  };
  const BaseFormat format = t.image->baseFormat;
  const float border = format == BaseFormat::rgb || format == BaseFormat::luminance ? 1.0f
                       : format == BaseFormat::intensity                            ? t.borderColor.r
                                                                                    : t.borderColor.a;
  return t.image->opaque &&
         (border >= 1 || !(reaches(t.wrapS) || reaches(t.wrapT) ||
                           (t.target == scene::TextureTarget::texture3D && reaches(t.wrapR))));
}

/// The alpha that a part of a combiner computes if `primary` and `previous` have alpha 1; empty if it depends
/// on texels.
std::optional<float> alphaOf(const std::vector<scene::Texture>& all, const scene::Texture& t,
                             const Combine::Part& part) {
  float a[3] = {};
  for (size_t i = 0; i < argumentsOf(part.function); ++i) {
    const Combine::Argument& argument = part.arguments[i];
    float alpha = 1;
    if (argument.source == Combine::constant) alpha = t.envColor.a;
    if (argument.source == Combine::texture || argument.source >= Combine::textureUnit) {
      const uint32_t unit =
          argument.source == Combine::texture ? t.unit : argument.source - uint32_t{Combine::textureUnit};
      const auto opaque = [&](const scene::Texture& x) { return x.unit == unit && isOpaque(x); };
      if (std::none_of(all.begin(), all.end(), opaque)) return std::nullopt;
    }
    a[i] = argument.operand == Combine::oneMinusAlpha ? 1 - alpha : alpha;
  }
  switch (part.function) {
    case Combine::replace: return a[0] * part.scale;
    case Combine::modulate: return a[0] * a[1] * part.scale;
    case Combine::add: return (a[0] + a[1]) * part.scale;
    case Combine::addSigned: return (a[0] + a[1] - 0.5f) * part.scale;
    case Combine::interpolate: return (a[0] * a[2] + a[1] * (1 - a[2])) * part.scale;
    case Combine::subtract: return (a[0] - a[1]) * part.scale;
    default: return std::nullopt;
  }
}

}  // namespace

bool readEnvironment(const RealGl& real, scene::Texture& texture) {
  const auto env = toEnv(environment(real, GL_TEXTURE_ENV_MODE));
  if (!env) return false;
  texture.env = *env;
  real.GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(texture.envColor));
  if (*env != TexEnv::combine) return true;
  return readPart(real, GL_COMBINE_RGB, GL_SOURCE0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE, texture.combine.rgb) &&
         readPart(real, GL_COMBINE_ALPHA, GL_SOURCE0_ALPHA, GL_OPERAND0_ALPHA, GL_ALPHA_SCALE,
                  texture.combine.alphaPart);
}

bool readTexGen(const RealGl& real, TexGen& gen) {
  for (size_t i = 0; i < 4; ++i) {
    const auto n = static_cast<GLenum>(i);
    if (!real.IsEnabled(GL_TEXTURE_GEN_S + n)) continue;
    GLint name = 0;
    real.GetTexGeniv(GL_S + n, GL_TEXTURE_GEN_MODE, &name);
    const auto mode = toMode(name);
    if (!mode) return false;
    gen.coordinates[i].mode = *mode;
    if (*mode == TexGen::objectLinear || *mode == TexGen::eyeLinear)
      real.GetTexGenfv(GL_S + n, *mode == TexGen::objectLinear ? GL_OBJECT_PLANE : GL_EYE_PLANE,
                       glm::value_ptr(gen.coordinates[i].plane));
  }
  return true;
}

uint32_t otherUnits(const scene::Texture& texture) {
  uint32_t units = 0;
  if (texture.env != TexEnv::combine) return 0;
  for (const Combine::Part* part : {&texture.combine.rgb, &texture.combine.alphaPart})
    for (size_t i = 0; i < argumentsOf(part->function); ++i)
      if (const uint8_t source = part->arguments[i].source; source >= Combine::textureUnit)
        units |= 1u << (source - Combine::textureUnit);
  return units;
}

bool keepOpaque(const std::vector<scene::Texture>& textures) {
  return std::all_of(textures.begin(), textures.end(), [&](const scene::Texture& t) {
    if (t.env == TexEnv::decal) return true;
    if (t.env == TexEnv::blend && t.image->baseFormat == scene::BaseFormat::intensity && t.envColor.a < 1)
      return false;
    if (t.env != TexEnv::combine) return isOpaque(t);
    if (t.combine.rgb.function == Combine::dot3Rgba) return false;
    const auto alpha = alphaOf(textures, t, t.combine.alphaPart);
    return alpha && *alpha >= 1;
  });
}

}  // namespace gluray::gl
