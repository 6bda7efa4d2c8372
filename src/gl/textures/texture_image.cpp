#include "gl/textures/texture_image.h"

#include "gl/real/state_queries.h"
#include "gl/textures/pixel_guard.h"
#include "scene/srgb.h"

#include <GL/glext.h>

#include <algorithm>
#include <iterator>
#include <optional>

namespace gluray::gl {
namespace {

GLint parameter(const RealGl& real, GLenum target, GLenum name, GLint usual) {
  real.GetTexParameteriv(target, name, &usual);
  return usual;
}

/// The target for queries of a level, which for a cube map must name one of its faces.
GLenum faceTarget(GLenum target, int face) {
  return target == GL_TEXTURE_CUBE_MAP ? static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face) : target;
}
int facesOf(GLenum target) { return target == GL_TEXTURE_CUBE_MAP ? 6 : 1; }

GLint levelParameter(const RealGl& real, GLenum target, GLint level, GLenum name) {
  GLint value = 0;
  real.GetTexLevelParameteriv(target, level, name, &value);
  return value;
}

struct LevelSize {
  GLint width = 0, height = 1, depth = 1, format = 0;
  bool operator==(const LevelSize&) const = default;
};

LevelSize sizeOf(const RealGl& real, GLenum target, GLint level, int face = 0) {
  const GLenum t = faceTarget(target, face);
  LevelSize size;
  size.width = levelParameter(real, t, level, GL_TEXTURE_WIDTH);
  if (target != GL_TEXTURE_1D) size.height = levelParameter(real, t, level, GL_TEXTURE_HEIGHT);
  if (target == GL_TEXTURE_3D) size.depth = levelParameter(real, t, level, GL_TEXTURE_DEPTH);
  size.format = levelParameter(real, t, level, GL_TEXTURE_INTERNAL_FORMAT);
  return size;
}

/// Whether texels of the format are decoded from sRGB when they are sampled.
bool isSrgb(GLint format) {
  return (format >= GL_SRGB && format <= GL_COMPRESSED_SLUMINANCE_ALPHA) ||
         (format >= GL_COMPRESSED_SRGB_S3TC_DXT1_EXT && format <= GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT) ||
         format == GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM || format == GL_COMPRESSED_SRGB8_ETC2 ||
         format == GL_COMPRESSED_SRGB8_PUNCHTHROUGH_ALPHA1_ETC2 ||
         format == GL_COMPRESSED_SRGB8_ALPHA8_ETC2_EAC;
}

/// Whether llvmpipe keeps texels of the format compressed and filters them as floats, although each of their
/// components has eight bits (scene::Texture::byteFilter).
bool isFxt1(GLint format) {
  return format == GL_COMPRESSED_RGB_FXT1_3DFX || format == GL_COMPRESSED_RGBA_FXT1_3DFX;
}

/// How the texels of a texture are read and interpreted.
struct TexelForm {
  scene::BaseFormat base = scene::BaseFormat::rgba;
  bool bytes = true;  // eight bits per component suffice
  bool srgb = false, depth = false;
  bool normalised = true;  // components lie in 0 .. 1
};

std::optional<TexelForm> formOf(const RealGl& real, const RareState& has, GLenum target,
                                const ImageRange& range) {
  const auto ask = [&](GLenum name) { return levelParameter(real, faceTarget(target, 0), range.base, name); };
  const GLint r = ask(GL_TEXTURE_RED_SIZE), g = ask(GL_TEXTURE_GREEN_SIZE), b = ask(GL_TEXTURE_BLUE_SIZE),
              a = ask(GL_TEXTURE_ALPHA_SIZE), l = has.fixedFunction ? ask(GL_TEXTURE_LUMINANCE_SIZE) : 0,
              i = has.fixedFunction ? ask(GL_TEXTURE_INTENSITY_SIZE) : 0, d = ask(GL_TEXTURE_DEPTH_SIZE);
  TexelForm form;
  const GLint format = ask(GL_TEXTURE_INTERNAL_FORMAT);
  form.srgb = range.decode && isSrgb(format);
  form.depth = d > 0;
  form.bytes = std::max({r, g, b, a, l, i}) <= 8 && !form.srgb && !form.depth && !isFxt1(format);
  for (const GLenum type : {GL_TEXTURE_RED_TYPE, GL_TEXTURE_GREEN_TYPE, GL_TEXTURE_BLUE_TYPE,
                            GL_TEXTURE_ALPHA_TYPE, GL_TEXTURE_LUMINANCE_TYPE, GL_TEXTURE_INTENSITY_TYPE}) {
    if (!has.fixedFunction && (type == GL_TEXTURE_LUMINANCE_TYPE || type == GL_TEXTURE_INTENSITY_TYPE))
      continue;
    const GLint t = has.textureTypes ? ask(type) : GL_UNSIGNED_NORMALIZED;
    if (t == GL_NONE || t == GL_UNSIGNED_NORMALIZED) continue;
    if (t != GL_FLOAT && t != GL_SIGNED_NORMALIZED) return std::nullopt;  // integer formats are not traced
    form.bytes = form.normalised = false;
  }
  using scene::BaseFormat;
  if (form.depth) {
    if (range.depthMode == GL_ALPHA)
      form.base = BaseFormat::alpha;
    else
      form.base = range.depthMode == GL_INTENSITY ? BaseFormat::intensity : BaseFormat::luminance;
    return range.depthMode == GL_RED ? std::nullopt : std::optional(form);
  }
  if (i > 0)
    form.base = BaseFormat::intensity;
  else if (l > 0)
    form.base = a > 0 ? BaseFormat::luminanceAlpha : BaseFormat::luminance;
  else if (r > 0)
    form.base = a > 0 ? BaseFormat::rgba : BaseFormat::rgb;
  else if (a > 0)
    form.base = BaseFormat::alpha;
  else
    return std::nullopt;
  return form;
}

/// Converts a texel from glGetTexImage, which returns luminance as (L,0,0) and intensity as (I,0,0) (GL 2.1,
/// 6.1.4), to the value that sampling returns.
template <class Texel>
Texel expanded(const Texel& t, scene::BaseFormat format, decltype(t.x) one) {
  switch (format) {
    case scene::BaseFormat::luminance: return {t.x, t.x, t.x, one};
    case scene::BaseFormat::luminanceAlpha: return {t.x, t.x, t.x, t.w};
    case scene::BaseFormat::intensity: return {t.x, t.x, t.x, t.x};
    case scene::BaseFormat::alpha: return {0, 0, 0, t.w};
    case scene::BaseFormat::rgb: return {t.x, t.y, t.z, one};
    case scene::BaseFormat::rgba: return t;
  }
  return t;
}

void readBytes(const RealGl& real, GLenum target, GLint level, const TexelForm& form, scene::TexelGrid& grid,
               size_t first) {
  real.GetTexImage(target, level, GL_RGBA, GL_UNSIGNED_BYTE, grid.texels.data() + first);
  using Bytes = glm::vec<4, uint32_t>;
  if (form.base == scene::BaseFormat::rgba) return;
  std::transform(grid.texels.begin() + static_cast<std::ptrdiff_t>(first), grid.texels.end(),
                 grid.texels.begin() + static_cast<std::ptrdiff_t>(first), [&](uint32_t t) {
                   const Bytes b =
                       expanded(Bytes(t & 255, t >> 8 & 255, t >> 16 & 255, t >> 24), form.base, 255u);
                   return b.x | b.y << 8 | b.z << 16 | b.w << 24;
                 });
}

void readFloats(const RealGl& real, GLenum target, GLint level, const TexelForm& form, scene::TexelGrid& grid,
                size_t first) {
  glm::vec4* texels = grid.floats.data() + first;
  const size_t count = grid.floats.size() - first;
  if (form.depth) {
    std::vector<float> depths(count);
    real.GetTexImage(target, level, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    std::transform(depths.begin(), depths.end(), texels, [](float d) { return glm::vec4(d); });
  } else {
    real.GetTexImage(target, level, GL_RGBA, GL_FLOAT, texels);
  }
  for (size_t i = 0; i < count; ++i) {
    glm::vec4 t = texels[i];
    if (form.srgb)  // EXT_texture_sRGB
      t = {scene::decodedSrgb(t.x), scene::decodedSrgb(t.y), scene::decodedSrgb(t.z), t.w};
    texels[i] = expanded(t, form.base, 1.0f);
  }
}

void readLevel(const RealGl& real, GLenum target, GLint level, const TexelForm& form,
               scene::TexelGrid& grid) {
  const LevelSize size = sizeOf(real, target, level);
  const int faces = facesOf(target);
  grid.width = size.width, grid.height = size.height, grid.depth = size.depth * faces;
  const size_t slice =
      static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height) * static_cast<size_t>(size.depth);
  for (int face = 0; face < faces; ++face) {
    const size_t first = slice * static_cast<size_t>(face);
    if (form.bytes) {
      grid.texels.resize(first + slice);
      readBytes(real, faceTarget(target, face), level, form, grid, first);
    } else {
      grid.floats.resize(first + slice);
      readFloats(real, faceTarget(target, face), level, form, grid, first);
    }
  }
}

bool isOpaque(const scene::TexelGrid& grid) {
  return std::all_of(grid.texels.begin(), grid.texels.end(), [](uint32_t t) { return t >> 24 == 0xFF; }) &&
         std::all_of(grid.floats.begin(), grid.floats.end(), [](const glm::vec4& t) { return t.a == 1.0f; });
}

}  // namespace

bool isRgba8(const RealGl& real, glm::ivec2 size) {
  const LevelSize level = sizeOf(real, GL_TEXTURE_2D, 0);
  return level.width == size.x && level.height == size.y && level.format == GL_RGBA8;
}

bool holdsRgba8(const RealGl& real, glm::ivec2 size) {
  const LevelSize level = sizeOf(real, GL_TEXTURE_2D, 0);
  return level.width >= size.x && level.height >= size.y && level.format == GL_RGBA8;
}

ImageRange rangeOf(const RealGl& real, const RareState& has, GLenum target, bool mipmapped) {
  ImageRange range;
  range.base = parameter(real, target, GL_TEXTURE_BASE_LEVEL, 0);
  GLint most = parameter(real, target, GL_TEXTURE_MAX_LEVEL, 1000);
  if (has.textureStorage && parameter(real, target, GL_TEXTURE_IMMUTABLE_FORMAT, 0)) {
    const GLint last = std::max(1, parameter(real, target, GL_TEXTURE_IMMUTABLE_LEVELS, 1)) - 1;
    range.base = std::min(range.base, last);
    most = std::clamp(most, range.base, last);
  }
  range.decode = !has.textureSrgb ||
                 parameter(real, target, GL_TEXTURE_SRGB_DECODE_EXT, GL_DECODE_EXT) != GL_SKIP_DECODE_EXT;
  range.depthMode = static_cast<GLenum>(
      has.fixedFunction ? parameter(real, target, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE) : GL_RED);
  const LevelSize base = sizeOf(real, target, range.base);
  if (base.width <= 0 || base.height <= 0 || base.depth <= 0 || most < range.base) return range;
  if (target == GL_TEXTURE_CUBE_MAP && base.width != base.height) return range;
  int levels = 1;
  for (int side = std::max({base.width, base.height, base.depth}); mipmapped && side > 1; side /= 2) ++levels;
  levels = std::min(levels, most - range.base + 1);
  for (int i = 0; i < levels; ++i) {
    const LevelSize expected{std::max(1, base.width >> i), std::max(1, base.height >> i),
                             std::max(1, base.depth >> i), base.format};
    for (int face = 0; face < facesOf(target); ++face)
      if (!(sizeOf(real, target, range.base + i, face) == expected)) return range;
  }
  range.levels = levels;
  return range;
}

std::shared_ptr<const scene::TextureImage> readImage(const RealGl& real, const RareState& has, GLenum target,
                                                     const ImageRange& range, Reason& reason) {
  constexpr double kMaxTexels = 1 << 26;
  const LevelSize size = sizeOf(real, target, range.base);
  const auto form = formOf(real, has, target, range);
  if (!form || levelParameter(real, faceTarget(target, 0), range.base, GL_TEXTURE_BORDER) != 0 ||
      static_cast<double>(size.width) * size.height * size.depth > kMaxTexels) {
    reason = Reason::textureFormat;
    return nullptr;
  }
  auto image = std::make_shared<scene::TextureImage>();
  image->baseFormat = form->base;
  image->normalised = form->normalised;
  image->mipmaps.resize(static_cast<size_t>(range.levels - 1));
  const PixelGuard guard(real, has.fixedFunction);
  readLevel(real, target, range.base, *form, *image);
  image->opaque = isOpaque(*image);
  for (size_t i = 0; i < image->mipmaps.size(); ++i) {
    readLevel(real, target, range.base + 1 + static_cast<GLint>(i), *form, image->mipmaps[i]);
    image->opaque = image->opaque && isOpaque(image->mipmaps[i]);
  }
  return image;
}

}  // namespace gluray::gl
