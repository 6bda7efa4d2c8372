#include "intercept/present/texture_put.h"

#include "base/timeline.h"
#include "gl/state_queries.h"
#include "gl/texture_image.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

namespace gluray::present {
namespace {

GLint ask(const gl::RealGl& real, GLenum attachment, GLenum name) {
  return gl::attachmentValue(real, GL_DRAW_FRAMEBUFFER, attachment, name);
}

/// The texture whose level 0 is attached, or 0.
GLuint textureAt(const gl::RealGl& real, GLenum attachment) {
  if (ask(real, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return 0;
  if (ask(real, attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL) != 0) return 0;
  return static_cast<GLuint>(ask(real, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
}

GLint ofLevel(const gl::RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, name, &value);
  return value;
}

bool isHit(float depth) { return depth <= 1.0f; }

}  // namespace

uint32_t depth24(float depth) {
  const float scaled = depth * 16777215.0f;
  // From 2^23 on floats are whole numbers; below, adding that much rounds as the processor does, to even.
  const float whole = scaled < 0x1p23f ? (scaled + 0x1p23f) - 0x1p23f : scaled;
  return static_cast<uint32_t>(static_cast<int32_t>(whole));
}

std::optional<TexturePut::Attached> TexturePut::attached(const gl::RealGl& real, StateGuard& guard,
                                                         const Features& features, const Image& image) const {
  Attached to;
  to.colorBuffer = static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER0));
  to.color = textureAt(real, to.colorBuffer), to.depth = textureAt(real, GL_DEPTH_ATTACHMENT);
  if (!to.color || !to.depth || !takeErrors(real).empty()) return std::nullopt;
  const glm::ivec2 end(image.x + image.width, image.y + image.height);
  guard.texture2D(features.textureUnit, to.color);  // an error where it is of another kind
  if (!takeErrors(real).empty() || !gl::holdsRgba8(real, end)) return std::nullopt;
  guard.texture2D(features.textureUnit + 1, to.depth);
  if (!takeErrors(real).empty() || ofLevel(real, GL_TEXTURE_WIDTH) < end.x ||
      ofLevel(real, GL_TEXTURE_HEIGHT) < end.y)
    return std::nullopt;
  to.depthFormat = static_cast<GLenum>(ofLevel(real, GL_TEXTURE_INTERNAL_FORMAT));
  const bool known = to.depthFormat == GL_DEPTH24_STENCIL8 || to.depthFormat == GL_DEPTH_COMPONENT32F;
  return known ? std::optional(to) : std::nullopt;
}

uint32_t TexturePut::bitsOf(const gl::RealGl& real, StateGuard& guard, const Attached& to,
                            const gl::ClearedTarget& cleared) {
  if (color_ == cleared.color) return bits_;
  guard.plainPack();
  guard.readFrom(cleared.framebuffer, to.colorBuffer);
  real.ReadPixels(cleared.region.x, cleared.region.y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &bits_);
  color_ = cleared.color;
  return bits_;
}

void TexturePut::fill(const Image& image, const Part& part, uint32_t background, bool floats) {
  const Band& band = part.band;
  const auto width = static_cast<size_t>(band.width);
  for (int row = 0; row < band.height; ++row) {
    const size_t from = static_cast<size_t>(band.y + row) * static_cast<size_t>(image.width) +
                        static_cast<size_t>(band.x),
                 to = part.first + static_cast<size_t>(row) * width;
    const uint32_t* color = &image.color[from];
    const float* depth = &image.depth[from];
    uint32_t *toColor = &colors_[to], *toDepth = &depths_[to];
    for (size_t i = 0; i < width; ++i) toColor[i] = isHit(depth[i]) ? color[i] : background;
    if (floats) {
      for (size_t i = 0; i < width; ++i) toDepth[i] = std::bit_cast<uint32_t>(std::min(depth[i], 1.0f));
    } else {  // stencil values are the lowest eight bits
      for (size_t i = 0; i < width; ++i) toDepth[i] = depth24(std::min(depth[i], 1.0f)) << 8;
    }
  }
}

void TexturePut::send(const gl::RealGl& real, const Features& features, const Image& image, const Part& part,
                      bool floats) const {
  const Band& at = part.band;
  const auto one = [&](int unit, GLenum format, GLenum type, const void* data) {
    real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    real.TexSubImage2D(GL_TEXTURE_2D, 0, image.x + at.x, image.y + at.y, at.width, at.height, format, type,
                       data);
  };
  one(features.textureUnit, GL_RGBA, GL_UNSIGNED_BYTE, &colors_[part.first]);
  if (floats)
    one(features.textureUnit + 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depths_[part.first]);
  else
    one(features.textureUnit + 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &depths_[part.first]);
}

void TexturePut::findParts(const Image& image) {
  parts_.clear();
  size_t pixels = 0;
  for (const Band& band : hitBands(image.depth.data(), image.width, image.height)) {
    parts_.push_back({band, pixels});
    pixels += static_cast<size_t>(band.width) * static_cast<size_t>(band.height);
  }
  if (colors_.size() < pixels) colors_.resize(pixels), depths_.resize(pixels);
}

bool TexturePut::put(const gl::RealGl& real, const Features& features, const Image& image,
                     const gl::ClearedTarget& cleared, PendingErrors& pending) {
  if (image.samples != 1 || image.content != Image::Content::color || !image.center.empty()) return false;
  const timeline::Span span("put");
  pending = takeErrors(real);
  StateGuard guard(real, features);
  const std::optional<Attached> to = attached(real, guard, features, image);
  if (!to) return false;
  const uint32_t background = bitsOf(real, guard, *to, cleared);
  if (!takeErrors(real).empty()) return color_.reset(), false;
  guard.plainUnpack();
  const bool floats = to->depthFormat == GL_DEPTH_COMPONENT32F;
  findParts(image);
  tbb::parallel_for(size_t{0}, parts_.size(), [&](size_t i) { fill(image, parts_[i], background, floats); });
  for (const Part& part : parts_) send(real, features, image, part, floats);
  return takeErrors(real).empty();
}

}  // namespace gluray::present
