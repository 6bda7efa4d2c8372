#include "gl/state/attached_images.h"

#include "gl/handlers.h"
#include "gl/state/state_queries.h"

#include <new>

namespace gluray::gl {

void AttachedImages::set(GLuint framebuffer, GLenum attachment, GLenum type) {
  if (of(type).now() == 0 || framebuffer == 0) return;
  if (attachment == GL_DEPTH_STENCIL_ATTACHMENT) {
    setOne(framebuffer, GL_DEPTH_ATTACHMENT, type);
    setOne(framebuffer, GL_STENCIL_ATTACHMENT, type);
  } else {
    setOne(framebuffer, attachment, type);
  }
}

void AttachedImages::setOne(GLuint framebuffer, GLenum attachment, GLenum type) {
  try {
    attached_[{framebuffer, attachment}] = {type, of(type).now() + 1};
  } catch (const std::bad_alloc&) {}  // then the attachment counts as old
}

void AttachedImages::setBound(const RealGl& real, GLenum target, GLenum attachment, GLenum type) {
  if (of(type).now() == 0) return;
  const GLenum binding =
      target == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING;
  set(static_cast<GLuint>(integer(real, binding)), attachment, type);
}

bool AttachedImages::mayBeDeleted(const RealGl& real, GLenum target, GLenum attachment) const {
  if (textures_.now() == 0 && renderbuffers_.now() == 0) return false;
  const GLenum binding =
      target == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING;
  const auto framebuffer = static_cast<GLuint>(integer(real, binding));
  if (framebuffer == 0) return false;
  const auto ask = [&](GLenum name) { return attachmentValue(real, target, attachment, name); };
  const auto type = static_cast<GLenum>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE));
  if (type != GL_TEXTURE && type != GL_RENDERBUFFER) return false;
  const uint64_t deleted = of(type).when(static_cast<GLuint>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)));
  if (deleted == 0) return false;
  const auto it = attached_.find({framebuffer, attachment});
  return it == attached_.end() || it->second.type != type || it->second.when <= deleted;
}

uint32_t imageAttached(Context& c, GLenum target, GLenum attachment, GLenum type) {
  c.shadow.images.setBound(c.real, target, attachment, type);
  return kTarget;
}

uint32_t imageAttachedTo(Context& c, GLuint framebuffer, GLenum attachment, GLenum type) {
  c.shadow.images.set(framebuffer, attachment, type);
  return kTarget;
}

uint32_t renderbuffersDeleted(Context& c, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; names && i < n; ++i)
    if (names[i] != 0) c.failsafe.insist([&] { c.shadow.group.deletedRenderbuffers.add(names[i]); });
  return kTarget;
}

}  // namespace gluray::gl
