#include "gl/texture.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <optional>

namespace gluray::gl {
namespace {

GLint integer(const RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetIntegerv(name, &value);
  return value;
}

GLint levelParameter(const RealGl& real, GLenum target, GLint level, GLenum name) {
  GLint value = 0;
  real.GetTexLevelParameteriv(target, level, name, &value);
  return value;
}

GLenum bindingOf(GLenum target) {
  return target == GL_TEXTURE_1D ? GL_TEXTURE_BINDING_1D : GL_TEXTURE_BINDING_2D;
}

/// Unpack-independent reading: the program's pack state is set aside while texels are fetched.
class PackGuard {
 public:
  explicit PackGuard(const RealGl& real) : real_(real) {
    for (size_t i = 0; i < std::size(kNames); ++i) {
      real.GetIntegerv(kNames[i], &saved_[i]);
      real.PixelStorei(kNames[i], kNames[i] == GL_PACK_ALIGNMENT ? 4 : 0);
    }
    if (isPresent(real.GenBuffers)) {
      buffer_ = static_cast<GLuint>(integer(real, GL_PIXEL_PACK_BUFFER_BINDING));
      if (buffer_) real.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    }
  }
  ~PackGuard() {
    for (size_t i = 0; i < std::size(kNames); ++i) real_.PixelStorei(kNames[i], saved_[i]);
    if (buffer_) real_.BindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
  }
  PackGuard(const PackGuard&) = delete;
  PackGuard& operator=(const PackGuard&) = delete;

 private:
  static constexpr GLenum kNames[] = {GL_PACK_ALIGNMENT,    GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                                      GL_PACK_SKIP_PIXELS,  GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,
                                      GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES};
  const RealGl& real_;
  GLint saved_[std::size(kNames)] = {};
  GLuint buffer_ = 0;
};

/// Pixel transfer (scale, bias, maps) also acts on reading back: programs that set it are left alone.
bool pixelTransferIsPlain(const RealGl& real) {
  const GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
  const GLenum biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
  const auto number = [&](GLenum name) {
    GLfloat v = 0;
    real.GetFloatv(name, &v);
    return v;
  };
  return std::all_of(std::begin(scales), std::end(scales), [&](GLenum n) { return number(n) == 1.0f; }) &&
         std::all_of(std::begin(biases), std::end(biases), [&](GLenum n) { return number(n) == 0.0f; }) &&
         !integer(real, GL_MAP_COLOR);
}

/// Formats whose texels are decoded when they are sampled.
bool isSrgb(GLint format) {
  return (format >= GL_SRGB && format <= GL_COMPRESSED_SLUMINANCE_ALPHA) ||
         (format >= GL_COMPRESSED_SRGB_S3TC_DXT1_EXT && format <= GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT) ||
         format == GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM || format == GL_COMPRESSED_SRGB8_ETC2;
}

std::optional<scene::BaseFormat> baseFormat(const RealGl& real, GLenum target) {
  const auto bits = [&](GLenum name) { return levelParameter(real, target, 0, name); };
  const GLint r = bits(GL_TEXTURE_RED_SIZE), g = bits(GL_TEXTURE_GREEN_SIZE), b = bits(GL_TEXTURE_BLUE_SIZE),
              a = bits(GL_TEXTURE_ALPHA_SIZE), l = bits(GL_TEXTURE_LUMINANCE_SIZE),
              i = bits(GL_TEXTURE_INTENSITY_SIZE);
  if (std::max({r, g, b, a, l, i}) > 8) return std::nullopt;  // more precision than eight bits carry
  for (const GLenum type :
       {GL_TEXTURE_RED_TYPE, GL_TEXTURE_ALPHA_TYPE, GL_TEXTURE_LUMINANCE_TYPE, GL_TEXTURE_INTENSITY_TYPE})
    if (const GLint t = bits(type); t != GL_NONE && t != GL_UNSIGNED_NORMALIZED) return std::nullopt;
  if (isSrgb(bits(GL_TEXTURE_INTERNAL_FORMAT))) return std::nullopt;
  if (i > 0) return scene::BaseFormat::intensity;
  if (l > 0) return a > 0 ? scene::BaseFormat::luminanceAlpha : scene::BaseFormat::luminance;
  if (r > 0 && g > 0 && b > 0) return a > 0 ? scene::BaseFormat::rgba : scene::BaseFormat::rgb;
  if (a > 0 && r == 0) return scene::BaseFormat::alpha;
  return std::nullopt;
}

/// glGetTexImage answers luminance as (L,0,0) and intensity as (I,0,0): GL 2.1, 6.1.4. Expands to what
/// sampling sees.
void expand(std::vector<uint32_t>& texels, scene::BaseFormat format) {
  for (uint32_t& t : texels) {
    const uint32_t r = t & 0xFF, a = t >> 24;
    switch (format) {
      case scene::BaseFormat::luminance: t = r | r << 8 | r << 16 | 0xFF000000u; break;
      case scene::BaseFormat::luminanceAlpha: t = r | r << 8 | r << 16 | a << 24; break;
      case scene::BaseFormat::intensity: t = r | r << 8 | r << 16 | r << 24; break;
      case scene::BaseFormat::alpha: t = a << 24; break;
      case scene::BaseFormat::rgb: t |= 0xFF000000u; break;
      case scene::BaseFormat::rgba: break;
    }
  }
}

/// Reads level 0 of the texture bound to `target`. Null with a reason where it cannot be traced.
std::shared_ptr<const scene::TextureImage> readImage(const RealGl& real, GLenum target, Reason& reason) {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = levelParameter(real, target, 0, GL_TEXTURE_WIDTH);
  image->height = target == GL_TEXTURE_1D ? 1 : levelParameter(real, target, 0, GL_TEXTURE_HEIGHT);
  if (image->width <= 0 || image->height <= 0) {
    reason = Reason::textureIncomplete;
    return nullptr;
  }
  const auto format = baseFormat(real, target);
  if (!format || levelParameter(real, target, 0, GL_TEXTURE_BORDER) != 0 || !pixelTransferIsPlain(real)) {
    reason = Reason::textureFormat;
    return nullptr;
  }
  image->baseFormat = *format;
  image->texels.resize(static_cast<size_t>(image->width) * static_cast<size_t>(image->height));
  {
    const PackGuard guard(real);
    real.GetTexImage(target, 0, GL_RGBA, GL_UNSIGNED_BYTE, image->texels.data());
  }
  expand(image->texels, *format);
  image->opaque =
      std::all_of(image->texels.begin(), image->texels.end(), [](uint32_t t) { return t >> 24 == 0xFF; });
  return image;
}

scene::Wrap toWrap(GLint mode) {
  switch (mode) {
    case GL_CLAMP: return scene::Wrap::clamp;
    case GL_CLAMP_TO_EDGE: return scene::Wrap::clampToEdge;
    case GL_CLAMP_TO_BORDER: return scene::Wrap::clampToBorder;
    case GL_MIRRORED_REPEAT: return scene::Wrap::mirroredRepeat;
    default: return scene::Wrap::repeat;
  }
}

std::optional<scene::TexEnv> readEnv(const RealGl& real) {
  GLint mode = GL_MODULATE;
  real.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mode);
  switch (mode) {
    case GL_MODULATE: return scene::TexEnv::modulate;
    case GL_REPLACE: return scene::TexEnv::replace;
    case GL_DECAL: return scene::TexEnv::decal;
    case GL_BLEND: return scene::TexEnv::blend;
    case GL_ADD: return scene::TexEnv::add;
    default: return std::nullopt;  // GL_COMBINE
  }
}

/// Sampling parameters of the bound texture. False where minification uses mipmaps.
bool readSampling(const RealGl& real, GLenum target, scene::Texture& texture) {
  const auto parameter = [&](GLenum name) {
    GLint v = 0;
    real.GetTexParameteriv(target, name, &v);
    return v;
  };
  texture.dimensions = target == GL_TEXTURE_1D ? 1 : 2;
  texture.wrapS = toWrap(parameter(GL_TEXTURE_WRAP_S));
  texture.wrapT = toWrap(parameter(GL_TEXTURE_WRAP_T));
  texture.magFilter =
      parameter(GL_TEXTURE_MAG_FILTER) == GL_NEAREST ? scene::Filter::nearest : scene::Filter::linear;
  const GLint min = parameter(GL_TEXTURE_MIN_FILTER);
  texture.minFilter = min == GL_NEAREST ? scene::Filter::nearest : scene::Filter::linear;
  real.GetTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, glm::value_ptr(texture.borderColor));
  return min == GL_NEAREST || min == GL_LINEAR;
}

/// Whether level 0 is sampled as it is: no other base level, no swizzle, no comparison, no sampler object in
/// its place.
bool isPlainlySampled(const RealGl& real, GLenum target) {
  const auto parameter = [&](GLenum name, GLint usual) {
    GLint v = usual;
    real.GetTexParameteriv(target, name, &v);
    return v;
  };
  if (isPresent(real.BindSampler) && integer(real, GL_SAMPLER_BINDING) != 0) return false;
  return parameter(GL_TEXTURE_BASE_LEVEL, 0) == 0 && parameter(GL_TEXTURE_COMPARE_MODE, GL_NONE) == GL_NONE &&
         parameter(GL_TEXTURE_SWIZZLE_R, GL_RED) == GL_RED &&
         parameter(GL_TEXTURE_SWIZZLE_G, GL_GREEN) == GL_GREEN &&
         parameter(GL_TEXTURE_SWIZZLE_B, GL_BLUE) == GL_BLUE &&
         parameter(GL_TEXTURE_SWIZZLE_A, GL_ALPHA) == GL_ALPHA;
}

/// Whether nothing was ever loaded into the bound texture: texturing is then as if disabled (GL 2.1, 3.8.10).
bool hasNoImage(const RealGl& real, GLenum target) {
  GLint base = 0;
  real.GetTexParameteriv(target, GL_TEXTURE_BASE_LEVEL, &base);
  return levelParameter(real, target, base, GL_TEXTURE_WIDTH) == 0;
}

/// The highest-ranking enabled target of the active unit (GL 2.1, 3.8.15), 0 where texturing is off.
GLenum enabledTarget(const RealGl& real) {
  for (const GLenum target :
       {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_2D, GL_TEXTURE_1D})
    if (real.IsEnabled(target)) return target;
  return 0;
}

/// Makes a unit active for the life of the object.
class ActiveUnit {
 public:
  explicit ActiveUnit(const RealGl& real) : real_(real), saved_(integer(real, GL_ACTIVE_TEXTURE)) {}
  ~ActiveUnit() { select(static_cast<GLenum>(saved_)); }
  ActiveUnit(const ActiveUnit&) = delete;
  ActiveUnit& operator=(const ActiveUnit&) = delete;
  void select(GLenum unit) {
    if (isPresent(real_.ActiveTexture)) real_.ActiveTexture(unit);
  }

 private:
  const RealGl& real_;
  GLint saved_;
};

}  // namespace

void TextureCache::imageChanged(const RealGl& real, GLenum target) {
  if (target != GL_TEXTURE_1D && target != GL_TEXTURE_2D) return;  // proxies, and targets that are not traced
  images_.erase({target, static_cast<GLuint>(integer(real, bindingOf(target)))});
}

std::shared_ptr<const scene::TextureImage> TextureCache::image(const RealGl& real, GLenum target, GLuint name,
                                                               Reason& reason) {
  const auto known = images_.find({target, name});
  if (known != images_.end()) return known->second;
  auto image = readImage(real, target, reason);
  if (image) images_[{target, name}] = image;
  return image;
}

void TextureCache::read(const RealGl& real, State& state) {
  state.textures.clear();
  state.textureReason = Reason::traced;
  ActiveUnit unit(real);
  const GLint units = isPresent(real.ActiveTexture) ? integer(real, GL_MAX_TEXTURE_UNITS) : 1;
  for (GLint i = 1; i < units; ++i) {
    unit.select(static_cast<GLenum>(GL_TEXTURE0 + i));
    if (enabledTarget(real)) state.textureReason = Reason::textureUnits;
  }
  unit.select(GL_TEXTURE0);
  const GLenum target = enabledTarget(real);
  if (!target || state.textureReason != Reason::traced) return;
  if (target != GL_TEXTURE_1D && target != GL_TEXTURE_2D)
    return void(state.textureReason = Reason::textureKind);
  const bool another = target == GL_TEXTURE_2D && real.IsEnabled(GL_TEXTURE_1D);
  if (!another && hasNoImage(real, target)) return;
  for (const GLenum gen : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q})
    if (real.IsEnabled(gen)) return void(state.textureReason = Reason::texGen);
  const auto env = readEnv(real);
  if (!env) return void(state.textureReason = Reason::textureEnv);
  scene::Texture texture;
  if (!readSampling(real, target, texture)) return void(state.textureReason = Reason::textureMipmap);
  if (!isPlainlySampled(real, target)) return void(state.textureReason = Reason::textureFormat);
  texture.env = *env;
  real.GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(texture.envColor));
  real.GetFloatv(GL_TEXTURE_MATRIX, glm::value_ptr(texture.textureMatrix));
  texture.image =
      image(real, target, static_cast<GLuint>(integer(real, bindingOf(target))), state.textureReason);
  if (texture.image) state.textures.push_back(std::move(texture));
}

}  // namespace gluray::gl
