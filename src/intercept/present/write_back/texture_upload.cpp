#include "intercept/present/write_back/texture_upload.h"

#include "base/timeline.h"
#include "frame/pixels/pixel_rows.h"
#include "gl/real/state_queries.h"
#include "gl/textures/texture_image.h"
#include "parallel/loops.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>

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

}  // namespace

bool makesMipmaps(const gl::RealGl& real, const Features& features) {
  GLint makes = GL_FALSE;
  if (features.compatibility) real.GetTexParameteriv(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, &makes);
  return makes != GL_FALSE;
}

std::optional<TextureUpload::Attached> TextureUpload::attached(const gl::RealGl& real, StateGuard& guard,
                                                               const Features& features,
                                                               const Image& image) const {
  Attached to;
  to.color = textureAt(real, static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER0)));
  to.depth = textureAt(real, GL_DEPTH_ATTACHMENT);
  if (!to.color || !to.depth || !takeErrors(real).empty()) return std::nullopt;
  const glm::ivec2 end(image.x + image.width, image.y + image.height);
  guard.texture2D(features.textureUnit, to.color);  // a GL error if it has another target
  if (!takeErrors(real).empty() || !gl::holdsRgba8(real, end) || makesMipmaps(real, features))
    return std::nullopt;
  guard.texture2D(features.textureUnit + 1, to.depth);
  if (!takeErrors(real).empty() || ofLevel(real, GL_TEXTURE_WIDTH) < end.x ||
      ofLevel(real, GL_TEXTURE_HEIGHT) < end.y || makesMipmaps(real, features))
    return std::nullopt;
  to.depthFormat = static_cast<GLenum>(ofLevel(real, GL_TEXTURE_INTERNAL_FORMAT));
  const bool known = to.depthFormat == GL_DEPTH24_STENCIL8 || to.depthFormat == GL_DEPTH_COMPONENT32F;
  return known ? std::optional(to) : std::nullopt;
}

void TextureUpload::fillDepths(const Image& image, const frame::Band& band, bool floats) {
  const auto width = static_cast<size_t>(image.width), count = static_cast<size_t>(band.width);
  for (int y = band.y; y < band.y + band.height; ++y) {
    const size_t first = static_cast<size_t>(y) * width + static_cast<size_t>(band.x);
    (floats ? frame::toDepthFloat : frame::toDepth24)(&image.depth[first], count,
                                                      &depths_[first]);  // stencil values are 0
  }
}

void TextureUpload::send(const gl::RealGl& real, const Features& features, const Image& image,
                         const frame::Band& band, bool floats) const {
  const size_t first =
      static_cast<size_t>(band.y) * static_cast<size_t>(image.width) + static_cast<size_t>(band.x);
  const auto one = [&](int unit, GLenum format, GLenum type, const void* data) {
    real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    real.TexSubImage2D(GL_TEXTURE_2D, 0, image.x + band.x, image.y + band.y, band.width, band.height, format,
                       type, data);
  };
  one(features.textureUnit, GL_RGBA, GL_UNSIGNED_BYTE, &image.color[first]);
  if (floats)
    one(features.textureUnit + 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depths_[first]);
  else
    one(features.textureUnit + 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &depths_[first]);
}

bool TextureUpload::put(const gl::RealGl& real, const Features& features, const Image& image, int threads,
                        PendingErrors& pending) {
  if (!image.isPlain()) return false;
  const timeline::Span span("put");
  pending = takeErrors(real);
  StateGuard guard(real, features);
  const std::optional<Attached> to = attached(real, guard, features, image);
  if (!to) return false;
  guard.plainUnpack(image.width);
  const bool floats = to->depthFormat == GL_DEPTH_COMPONENT32F;
  if (depths_.size() < image.depth.size()) depths_.resize(image.depth.size());
  const int rows = frame::rowsOfBands(image.height), count = (image.height + rows - 1) / rows;
  std::array<frame::Band, frame::kMaxBands> bands;
  forEachPart(threads, count, [&](int i) {  // reads each depth once
    frame::Band& band = bands[static_cast<size_t>(i)];
    band = frame::hitBand(image.depth.data(), image.width, image.height, i * rows);
    if (band.width > 0) fillDepths(image, band, floats);
  });
  for (int i = 0; i < count; ++i)
    if (const frame::Band& band = bands[static_cast<size_t>(i)]; band.width > 0)
      send(real, features, image, band, floats);
  return takeErrors(real).empty();
}

}  // namespace gluray::present
