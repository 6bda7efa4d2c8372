#include "gl/textures/texture_sampling.h"

#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstring>
#include <optional>

namespace gluray::gl {
namespace {

std::optional<scene::Wrap> toWrap(GLint mode) {
  switch (mode) {
    case GL_REPEAT: return scene::Wrap::repeat;
    case GL_CLAMP: return scene::Wrap::clamp;
    case GL_CLAMP_TO_EDGE: return scene::Wrap::clampToEdge;
    case GL_CLAMP_TO_BORDER: return scene::Wrap::clampToBorder;
    case GL_MIRRORED_REPEAT: return scene::Wrap::mirroredRepeat;
    case GL_MIRROR_CLAMP_EXT: return scene::Wrap::mirrorClamp;
    case GL_MIRROR_CLAMP_TO_EDGE: return scene::Wrap::mirrorClampToEdge;
    case GL_MIRROR_CLAMP_TO_BORDER_EXT: return scene::Wrap::mirrorClampToBorder;
    default: return std::nullopt;
  }
}

scene::Filter toFilter(GLint mode) {
  const bool nearest =
      mode == GL_NEAREST || mode == GL_NEAREST_MIPMAP_NEAREST || mode == GL_NEAREST_MIPMAP_LINEAR;
  return nearest ? scene::Filter::nearest : scene::Filter::linear;
}

scene::MipFilter toMipFilter(GLint mode) {
  switch (mode) {
    case GL_NEAREST_MIPMAP_NEAREST:
    case GL_LINEAR_MIPMAP_NEAREST: return scene::MipFilter::nearest;
    case GL_NEAREST_MIPMAP_LINEAR:
    case GL_LINEAR_MIPMAP_LINEAR: return scene::MipFilter::linear;
    default: return scene::MipFilter::none;
  }
}

scene::LodRule lodRuleOf(const RealGl& real) {
  const auto* name = reinterpret_cast<const char*>(real.GetString(GL_RENDERER));
  return name && std::strstr(name, "llvmpipe") ? scene::LodRule::llvmpipe : scene::LodRule::specified;
}

/// Sampling parameters of the active unit: those of its sampler object or, without one, of the texture that
/// is bound to `target`.
class Parameters {
 public:
  Parameters(const RealGl& real, GLenum target) : real_(real), target_(target), sampler_(samplerOf(real)) {}
  bool ofSampler() const { return sampler_ != 0; }
  /// `usual`: the value where the real OpenGL does not know the parameter.
  GLint integer(GLenum name, GLint usual) const {
    if (ofSampler())
      real_.GetSamplerParameteriv(sampler_, name, &usual);
    else
      real_.GetTexParameteriv(target_, name, &usual);
    return usual;
  }
  void read(GLenum name, GLfloat* values) const {
    if (ofSampler())
      real_.GetSamplerParameterfv(sampler_, name, values);
    else
      real_.GetTexParameterfv(target_, name, values);
  }

 private:
  const RealGl& real_;
  GLenum target_;
  GLuint sampler_;
};

/// Reads the level-of-detail state: bias of unit and texture, limits.
void readLod(const RealGl& real, const RareState& has, const Parameters& parameters,
             scene::Texture& texture) {
  GLfloat unit = 0, own = 0;
  if (has.fixedFunction) real.GetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, &unit);
  parameters.read(GL_TEXTURE_LOD_BIAS, &own);
  GLfloat most = 16;
  real.GetFloatv(GL_MAX_TEXTURE_LOD_BIAS, &most);
  texture.lodBias = std::clamp(unit + own, -most, most);
  parameters.read(GL_TEXTURE_MIN_LOD, &texture.minLod);
  parameters.read(GL_TEXTURE_MAX_LOD, &texture.maxLod);
  texture.lodRule = lodRuleOf(real);
}

/// Whether the renderer knows how the real OpenGL filters: OpenGL does not specify it, and Mesa 24 changed
/// it.
bool isKnownAnisotropy(const RealGl& real, GLenum target, const scene::Texture& texture) {
  const int mesa = mesaVersionOf(real.GetString(GL_VERSION));
  return mesa >= 2200 && mesa < 2400 && target == GL_TEXTURE_2D &&
         texture.lodRule == scene::LodRule::llvmpipe && texture.minFilter == scene::Filter::linear &&
         texture.magFilter == scene::Filter::linear;
}

/// Whether llvmpipe filters texels of eight bits in eight bits, with these wrap modes and filters.
bool hasByteFilter(GLenum target, const scene::Texture& t) {
  if (t.maxAnisotropy > 1) return false;
  const auto simple = [](scene::Wrap w) { return w == scene::Wrap::repeat || w == scene::Wrap::clampToEdge; };
  const bool linear = t.minFilter == scene::Filter::linear || t.magFilter == scene::Filter::linear;
  if (target == GL_TEXTURE_CUBE_MAP) return !(t.seamless && linear);  // wrap modes do not matter
  return simple(t.wrapS) && (target == GL_TEXTURE_1D || simple(t.wrapT)) &&
         (target != GL_TEXTURE_3D || simple(t.wrapR));
}

}  // namespace

GLuint samplerOf(const RealGl& real) {
  return isPresent(real.BindSampler) ? static_cast<GLuint>(integer(real, GL_SAMPLER_BINDING)) : 0;
}

bool isSwizzled(const RealGl& real, const RareState& has, GLenum target) {
  if (!has.textureSwizzle) return false;
  const auto is = [&](GLenum name, GLint component) {
    GLint value = component;
    real.GetTexParameteriv(target, name, &value);
    return value == component;
  };
  return !is(GL_TEXTURE_SWIZZLE_R, GL_RED) || !is(GL_TEXTURE_SWIZZLE_G, GL_GREEN) ||
         !is(GL_TEXTURE_SWIZZLE_B, GL_BLUE) || !is(GL_TEXTURE_SWIZZLE_A, GL_ALPHA);
}

Reason readSampling(const RealGl& real, const RareState& has, GLenum target, scene::Texture& texture) {
  const Parameters parameters(real, target);
  // Rectangles lack some wrap modes, and cube maps have a seam of their own by an extension.
  if (parameters.ofSampler() && (target == GL_TEXTURE_RECTANGLE || target == GL_TEXTURE_CUBE_MAP))
    return Reason::textureFormat;
  const auto parameter = [&](GLenum name, GLint usual) { return parameters.integer(name, usual); };
  const auto s = toWrap(parameter(GL_TEXTURE_WRAP_S, GL_REPEAT)),
             t = toWrap(parameter(GL_TEXTURE_WRAP_T, GL_REPEAT)),
             r = toWrap(parameter(GL_TEXTURE_WRAP_R, GL_REPEAT));
  if (!s || !t || !r) return Reason::textureFormat;
  texture.wrapS = *s, texture.wrapT = *t, texture.wrapR = *r;
  texture.magFilter = toFilter(parameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR));
  const GLint min = parameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  texture.minFilter = toFilter(min);
  texture.mipFilter = toMipFilter(min);
  parameters.read(GL_TEXTURE_BORDER_COLOR, glm::value_ptr(texture.borderColor));
  readLod(real, has, parameters, texture);
  if (has.anisotropy) parameters.read(GL_TEXTURE_MAX_ANISOTROPY_EXT, &texture.maxAnisotropy);
  if (texture.maxAnisotropy > 1 && !isKnownAnisotropy(real, target, texture))
    return Reason::textureAnisotropy;
  texture.seamless =
      target == GL_TEXTURE_CUBE_MAP && has.seamlessCubes && real.IsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  texture.byteFilter = has.byteFilters && hasByteFilter(target, texture);
  const bool plain = !isSwizzled(real, has, target) && parameter(GL_TEXTURE_COMPARE_MODE, GL_NONE) == GL_NONE;
  return plain ? Reason::traced : Reason::textureFormat;
}

}  // namespace gluray::gl
