#include "gl/state/attached_images.h"

#include "gl/real/state_queries.h"

#include <new>

namespace gluray::gl {
namespace {

GLuint boundTo(const RealGl& real, GLenum target) {
  const GLenum binding =
      target == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING;
  return static_cast<GLuint>(integer(real, binding));
}

}  // namespace

void AttachedImages::set(GLuint framebuffer, GLenum attachment, GLenum type, GLuint name) {
  if (framebuffer == 0) return;
  update();
  const Image image{type, name};
  if (attachment == GL_DEPTH_STENCIL_ATTACHMENT) {
    setOne(framebuffer, GL_DEPTH_ATTACHMENT, image);
    setOne(framebuffer, GL_STENCIL_ATTACHMENT, image);
  } else {
    setOne(framebuffer, attachment, image);
  }
}

void AttachedImages::setOne(GLuint framebuffer, GLenum attachment, const Image& image) {
  attached_.erase({framebuffer, attachment});
  if (image.name == 0) return;
  try {
    attached_[{framebuffer, attachment}] = image;
  } catch (const std::bad_alloc&) {}  // the attachment then counts as another context's
}

void AttachedImages::setBound(const RealGl& real, GLenum target, GLenum attachment, GLenum type,
                              GLuint name) {
  set(boundTo(real, target), attachment, type, name);
}

void AttachedImages::forget(GLuint framebuffer) {
  attached_.erase(attached_.lower_bound({framebuffer, 0}), attached_.upper_bound({framebuffer, ~GLenum{0}}));
}

void AttachedImages::update() {
  const bool known = deleted_.since(seen_, [&](GLenum type, GLuint name) {
    for (auto& [place, image] : attached_)
      if (image.type == type && image.name == name) image.deleted = true;
  });
  if (known) return;
  for (auto& [place, image] : attached_) image.deleted = true;
}

bool AttachedImages::mayBeDeleted(const RealGl& real, GLenum target, GLenum attachment) {
  if (deleted_.count() == 0) return false;
  update();
  const GLuint framebuffer = boundTo(real, target);
  if (framebuffer == 0 ||
      attachmentValue(real, target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
    return false;
  const auto it = attached_.find({framebuffer, attachment});
  return it == attached_.end() || it->second.deleted;
}

}  // namespace gluray::gl
