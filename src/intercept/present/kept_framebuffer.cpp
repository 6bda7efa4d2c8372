#include "intercept/present/kept_framebuffer.h"

#include "gl/real/state_queries.h"
#include "intercept/present/state/state_guard.h"

#include <GL/glext.h>

#include <optional>
#include <string>

namespace gluray::present {
namespace {

GLint valueOf(const gl::RealGl& real, GLenum attachment, GLenum name) {
  return gl::attachmentValue(real, GL_DRAW_FRAMEBUFFER, attachment, name);
}

GLenum drawnAttachment(const gl::RealGl& real, bool window) {
  const auto buffer = static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER0));
  if (!window) return buffer;
  switch (buffer) {
    case GL_FRONT:
    case GL_LEFT:
    case GL_FRONT_LEFT: return GL_FRONT_LEFT;
    case GL_BACK:
    case GL_BACK_LEFT: return GL_BACK_LEFT;
    default: return buffer == GL_NONE ? GL_NONE : GL_INVALID_ENUM;
  }
}

enum class Colors { none, bytes, floats };

/// What holds the attachment's values exactly, if anything does.
std::optional<Colors> colorsOf(const gl::RealGl& real, GLenum attachment) {
  if (attachment == GL_INVALID_ENUM) return std::nullopt;
  if (attachment == GL_NONE || valueOf(real, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
    return Colors::none;
  const GLint red = valueOf(real, attachment, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE);
  const GLint type = valueOf(real, attachment, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
  if (type == GL_UNSIGNED_NORMALIZED) return red <= 8 ? Colors::bytes : Colors::floats;
  return type == GL_FLOAT ? std::optional(Colors::floats) : std::nullopt;
}

/// Whether floats hold its depths exactly.
bool hasExactDepth(const gl::RealGl& real, bool window) {
  const GLenum depth = window ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  if (valueOf(real, depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE) return false;
  return valueOf(real, depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT ||
         valueOf(real, depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE) <= 24;
}

}  // namespace

bool KeptFramebuffer::keep(const gl::RealGl& real, PresentedImages& shared, const scene::Region& region) {
  const Features& has = shared.features(real);
  if (!has.readFramebuffers) return false;
  const auto framebuffer = static_cast<GLuint>(gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING));
  const std::optional<Colors> colors = colorsOf(real, drawnAttachment(real, framebuffer == 0));
  if (!colors || !hasExactDepth(real, framebuffer == 0)) return takeErrors(real), false;
  colors_ = *colors != Colors::none;
  const bool wide = *colors == Colors::floats;
  image_.resize(region.width, region.height, 1, wide ? Image::kWide : Image::kColorDepth);
  image_.x = region.x, image_.y = region.y;
  std::string why;
  if (!shared.writeBack(real, WriteBack::colorsOf(image_)).ready(why)) return false;
  StateGuard guard(real, has);
  guard.plainPack();
  guard.readFrom(framebuffer, static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER0)));
  const auto read = [&](GLenum format, GLenum type, void* to) {
    real.ReadPixels(region.x, region.y, region.width, region.height, format, type, to);
  };
  read(GL_DEPTH_COMPONENT, GL_FLOAT, image_.depth.data());
  if (wide) read(GL_RGBA, GL_FLOAT, image_.wideColor.data());
  if (colors_ && !wide) read(GL_RGBA, GL_UNSIGNED_BYTE, image_.color.data());
  return takeErrors(real).empty();
}

void KeptFramebuffer::putBack(const gl::RealGl& real, PresentedImages& shared) {
  WriteBackTarget target;
  target.depthFunc = GL_ALWAYS, target.colors = colors_, target.encodes = false;
  PendingErrors pending;
  shared.writeBack(real, WriteBack::colorsOf(image_)).write(image_, target, pending);
  takeErrors(real);
}

}  // namespace gluray::present
