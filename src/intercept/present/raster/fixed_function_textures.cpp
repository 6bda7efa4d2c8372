#include "intercept/present/raster/fixed_function_textures.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gluray::present {
namespace {

using gl::RealGl;
using scene::Combine;
using scene::TexGen;
using scene::TextureTarget;

constexpr GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP,
                               GL_TEXTURE_RECTANGLE};  // by scene::TextureTarget

GLint wrapName(scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::repeat: return GL_REPEAT;
    case scene::Wrap::clamp: return GL_CLAMP;
    case scene::Wrap::clampToEdge: return GL_CLAMP_TO_EDGE;
    case scene::Wrap::clampToBorder: return GL_CLAMP_TO_BORDER;
    case scene::Wrap::mirroredRepeat: return GL_MIRRORED_REPEAT;
    case scene::Wrap::mirrorClamp: return GL_MIRROR_CLAMP_EXT;
    case scene::Wrap::mirrorClampToEdge: return GL_MIRROR_CLAMP_TO_EDGE;
    case scene::Wrap::mirrorClampToBorder: return GL_MIRROR_CLAMP_TO_BORDER_EXT;
  }
  return GL_REPEAT;
}

GLint minFilterName(const scene::Texture& t) {
  const bool nearest = t.minFilter == scene::Filter::nearest;
  switch (t.mipFilter) {
    case scene::MipFilter::none: return nearest ? GL_NEAREST : GL_LINEAR;
    case scene::MipFilter::nearest: return nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_NEAREST;
    case scene::MipFilter::linear: return nearest ? GL_NEAREST_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_LINEAR;
  }
  return GL_LINEAR;
}

GLint envName(scene::TexEnv env) {
  switch (env) {
    case scene::TexEnv::modulate: return GL_MODULATE;
    case scene::TexEnv::replace: return GL_REPLACE;
    case scene::TexEnv::decal: return GL_DECAL;
    case scene::TexEnv::blend: return GL_BLEND;
    case scene::TexEnv::add: return GL_ADD;
    case scene::TexEnv::combine: return GL_COMBINE;
  }
  return GL_MODULATE;
}

/// Internal format with the image's base format that can hold its texels. Texels are uploaded as RGBA:
/// luminance and intensity come from red, alpha from alpha (GL 2.1, table 3.15).
GLint internalFormat(const scene::TextureImage& image) {
  const bool bytes = image.floats.empty();
  switch (image.baseFormat) {
    case scene::BaseFormat::alpha: return bytes ? GL_ALPHA8 : GL_ALPHA32F_ARB;
    case scene::BaseFormat::luminance: return bytes ? GL_LUMINANCE8 : GL_LUMINANCE32F_ARB;
    case scene::BaseFormat::luminanceAlpha: return bytes ? GL_LUMINANCE8_ALPHA8 : GL_LUMINANCE_ALPHA32F_ARB;
    case scene::BaseFormat::intensity: return bytes ? GL_INTENSITY8 : GL_INTENSITY32F_ARB;
    case scene::BaseFormat::rgb: return bytes ? GL_RGB8 : GL_RGB32F;
    case scene::BaseFormat::rgba: return bytes ? GL_RGBA8 : GL_RGBA32F;
  }
  return GL_RGBA8;
}

void upload(const RealGl& real, GLenum target, GLint level, GLint format, const scene::TexelGrid& grid) {
  const bool bytes = grid.floats.empty();
  const GLenum type = bytes ? GL_UNSIGNED_BYTE : GL_FLOAT;
  const auto* data = bytes ? reinterpret_cast<const std::byte*>(grid.texels.data())
                           : reinterpret_cast<const std::byte*>(grid.floats.data());
  const size_t slice = static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height) *
                       (bytes ? sizeof(uint32_t) : sizeof(glm::vec4));
  switch (target) {
    case GL_TEXTURE_1D: return real.TexImage1D(target, level, format, grid.width, 0, GL_RGBA, type, data);
    case GL_TEXTURE_3D:
      return real.TexImage3D(target, level, format, grid.width, grid.height, grid.depth, 0, GL_RGBA, type,
                             data);
    case GL_TEXTURE_CUBE_MAP:
      for (GLenum face = 0; face < 6; ++face)
        real.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, format, grid.width, grid.height, 0,
                        GL_RGBA, type, data + face * slice);
      return;
    default: return real.TexImage2D(target, level, format, grid.width, grid.height, 0, GL_RGBA, type, data);
  }
}

GLint functionName(Combine::Function function) {
  constexpr GLint kNames[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                              GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
  return kNames[function];
}

void setPart(const RealGl& real, GLenum function, GLenum source, GLenum operand, GLenum scale,
             const Combine::Part& part) {
  constexpr GLint kSources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
  constexpr GLint kOperands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
  const bool alpha = function == GL_COMBINE_ALPHA;
  real.TexEnvi(GL_TEXTURE_ENV, function, functionName(part.function));
  for (GLenum i = 0; i < 3; ++i) {
    const Combine::Argument& a = part.arguments[i];
    real.TexEnvi(GL_TEXTURE_ENV, source + i,
                 a.source < Combine::textureUnit ? kSources[a.source]
                                                 : GL_TEXTURE0 + (a.source - Combine::textureUnit));
    const bool unused = alpha && a.operand < Combine::alpha;  // alpha parts take alpha only
    real.TexEnvi(GL_TEXTURE_ENV, operand + i, unused ? GL_SRC_ALPHA : kOperands[a.operand]);
  }
  real.TexEnvf(GL_TEXTURE_ENV, scale, part.scale);
}

/// Sets the unit's level-of-detail bias to the sum of unit and texture.
void setEnvironment(const RealGl& real, const Features& features, const scene::Texture& t) {
  real.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, envName(t.env));
  real.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(t.envColor));
  if (features.version >= 14) real.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, t.lodBias);
  if (t.env != scene::TexEnv::combine) return;
  setPart(real, GL_COMBINE_RGB, GL_SOURCE0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE, t.combine.rgb);
  setPart(real, GL_COMBINE_ALPHA, GL_SOURCE0_ALPHA, GL_OPERAND0_ALPHA, GL_ALPHA_SCALE, t.combine.alphaPart);
}

void setTexGen(const RealGl& real, const TexGen& gen) {
  constexpr GLint kModes[] = {
      0, GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP};
  for (GLenum i = 0; i < 4; ++i) {
    const TexGen::Coordinate& c = gen.coordinates[i];
    if (c.mode == TexGen::off) {
      real.Disable(GL_TEXTURE_GEN_S + i);
      continue;
    }
    real.Enable(GL_TEXTURE_GEN_S + i);
    real.TexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, kModes[c.mode]);
    if (c.mode == TexGen::objectLinear) real.TexGenfv(GL_S + i, GL_OBJECT_PLANE, glm::value_ptr(c.plane));
    if (c.mode == TexGen::eyeLinear) real.TexGenfv(GL_S + i, GL_EYE_PLANE, glm::value_ptr(c.plane));
  }
}

}  // namespace

ShadingTextures::ShadingTextures(const RealGl& real, const Features& features)
    : real_(real), features_(features) {
  GLint units = 1;
  if (features.version >= 13) real.GetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  on_.assign(static_cast<size_t>(std::clamp(units, 1, scene::kTextureUnits)), false);
}

ShadingTextures::~ShadingTextures() {
  for (const Matrix& m : matrices_) {
    select(m.unit);
    real_.MatrixMode(GL_TEXTURE);
    real_.LoadMatrixd(m.values);
  }
  select(0);
  for (const auto& [image, name] : names_) real_.DeleteTextures(1, &name);
  if (seamlessBefore_) setSeamless(*seamlessBefore_);
}

void ShadingTextures::setSeamless(bool on) {
  if (on)
    real_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  else
    real_.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void ShadingTextures::select(int unit) {
  if (features_.version >= 13) real_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
}

void ShadingTextures::turnOff(int unit) {
  select(unit);
  for (const GLenum target : kTargets) {
    if (target == GL_TEXTURE_RECTANGLE && !features_.rectangles) continue;
    if (target == GL_TEXTURE_1D || target == GL_TEXTURE_2D || features_.version >= 13) real_.Disable(target);
  }
  setTexGen(real_, {});
}

void ShadingTextures::keepMatrix(int unit) {
  if (std::any_of(matrices_.begin(), matrices_.end(), [&](const Matrix& m) { return m.unit == unit; }))
    return;
  Matrix& m = matrices_.emplace_back();
  m.unit = unit;
  real_.GetDoublev(GL_TEXTURE_MATRIX, m.values);
}

void ShadingTextures::set(const std::vector<scene::Texture>& textures) {
  for (size_t unit = 0; unit < on_.size(); ++unit) {
    if (on_[unit]) turnOff(static_cast<int>(unit));
    on_[unit] = false;
  }
  for (const scene::Texture& t : textures) {
    if (t.unit >= on_.size()) continue;
    on_[t.unit] = true;
    select(t.unit);
    const GLenum target = kTargets[static_cast<size_t>(t.target)];
    bind(t, target);
    real_.Enable(target);
    setEnvironment(real_, features_, t);
    setTexGen(real_, t.texGen);
    keepMatrix(t.unit);
    real_.MatrixMode(GL_TEXTURE);
    real_.LoadMatrixf(glm::value_ptr(t.textureMatrix));
  }
  select(0);
  real_.MatrixMode(GL_MODELVIEW);
}

void ShadingTextures::bind(const scene::Texture& texture, GLenum target) {
  const scene::TextureImage& image = *texture.image;
  const auto [found, fresh] = names_.try_emplace(&image, 0u);
  if (fresh) real_.GenTextures(1, &found->second);
  real_.BindTexture(target, found->second);
  for (int i = 0; fresh && i < image.levels(); ++i)
    upload(real_, target, i, internalFormat(image), image.level(i));
  if (target != GL_TEXTURE_RECTANGLE && features_.version >= 12)
    real_.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, image.levels() - 1);
  real_.TexParameteri(target, GL_TEXTURE_WRAP_S, wrapName(texture.wrapS));
  real_.TexParameteri(target, GL_TEXTURE_WRAP_T, wrapName(texture.wrapT));
  if (features_.version >= 12) real_.TexParameteri(target, GL_TEXTURE_WRAP_R, wrapName(texture.wrapR));
  real_.TexParameteri(target, GL_TEXTURE_MAG_FILTER,
                      texture.magFilter == scene::Filter::nearest ? GL_NEAREST : GL_LINEAR);
  real_.TexParameteri(target, GL_TEXTURE_MIN_FILTER, minFilterName(texture));
  if (features_.version >= 12) {
    real_.TexParameterf(target, GL_TEXTURE_MIN_LOD, texture.minLod);
    real_.TexParameterf(target, GL_TEXTURE_MAX_LOD, texture.maxLod);
  }
  real_.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, glm::value_ptr(texture.borderColor));
  anisotropic_ = anisotropic_ || texture.maxAnisotropy > 1;  // the program's OpenGL has the extension then
  if (anisotropic_) real_.TexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, texture.maxAnisotropy);
  constexpr int kHasSeamless = 32;
  if (target != GL_TEXTURE_CUBE_MAP || (features_.version < kHasSeamless && !texture.seamless)) return;
  if (!seamlessBefore_) seamlessBefore_ = real_.IsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  setSeamless(texture.seamless);
}

}  // namespace gluray::present
