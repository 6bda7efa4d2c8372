#include "gl/framebuffers/depth_copy.h"

#include "gl/real/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {
namespace {

GLint attachment(const RealGl& real, GLenum target, GLenum pname) {
  return attachmentValue(real, target, GL_DEPTH_ATTACHMENT, pname);
}

/// The depth attachment. target() assumes a 2D texture; for any other kind the copy raises an error.
struct DepthImage {
  GLint type = GL_NONE;
  GLuint name = 0;
  GLint level = 0;
  GLenum target() const { return type == GL_RENDERBUFFER ? GL_RENDERBUFFER : GL_TEXTURE_2D; }
};

DepthImage depthImage(const RealGl& real, GLenum target) {
  DepthImage image;
  image.type = attachment(real, target, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  if (image.type != GL_TEXTURE && image.type != GL_RENDERBUFFER) return {};
  image.name = static_cast<GLuint>(attachment(real, target, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  if (image.type == GL_TEXTURE)
    image.level = attachment(real, target, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
  return image;
}

/// Whether the framebuffer object is complete and has depth, and no stencil values that matter.
bool isPlain(const RealGl& real, GLenum target, bool stencilsSet) {
  if (real.CheckFramebufferStatus(target) != GL_FRAMEBUFFER_COMPLETE || !depthImage(real, target).name)
    return false;
  return !stencilsSet || attachment(real, target, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) == 0;
}

bool staysInPlace(const Blit& b) {
  return b.fromX0 == b.toX0 && b.fromY0 == b.toY0 && b.fromX1 == b.toX1 && b.fromY1 == b.toY1 &&
         b.fromX0 >= 0 && b.fromY0 >= 0 && b.fromX0 < b.fromX1 && b.fromY0 < b.fromY1;
}

bool isScissored(const RealGl& real, const Blit& b) {
  const glm::ivec4 box = scissorBox(real);
  return b.toX0 < box[0] || b.toY0 < box[1] || b.toX1 > box[0] + box[2] || b.toY1 > box[1] + box[3];
}

}  // namespace

bool isDepthCopy(const RealGl& real, AttachedImages& images, const Blit& b, bool stencilsSet) {
  if (!(b.mask & GL_DEPTH_BUFFER_BIT) || b.filter != GL_NEAREST || !staysInPlace(b)) return false;
  if (!isPresent(real.CopyImageSubData) || !integer(real, GL_READ_FRAMEBUFFER_BINDING) ||
      !integer(real, GL_DRAW_FRAMEBUFFER_BINDING))
    return false;
  if (!isPlain(real, GL_READ_FRAMEBUFFER, stencilsSet) || !isPlain(real, GL_DRAW_FRAMEBUFFER, stencilsSet) ||
      isScissored(real, b))
    return false;
  if (images.mayBeDeleted(real, GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT) ||
      images.mayBeDeleted(real, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT))
    return false;
  const DepthImage from = depthImage(real, GL_READ_FRAMEBUFFER), to = depthImage(real, GL_DRAW_FRAMEBUFFER);
  if (from.type == to.type && from.name == to.name) return false;
  // A blit without pixels raises the errors about samples and colour formats without copying anything.
  real.BlitFramebuffer(0, 0, 0, 0, 0, 0, 0, 0, b.mask, b.filter);
  return real.GetError() == GL_NO_ERROR;
}

bool copyDepth(const RealGl& real, const Blit& b) {
  const DepthImage from = depthImage(real, GL_READ_FRAMEBUFFER), to = depthImage(real, GL_DRAW_FRAMEBUFFER);
  real.CopyImageSubData(from.name, from.target(), from.level, b.fromX0, b.fromY0, 0, to.name, to.target(),
                        to.level, b.toX0, b.toY0, 0, b.fromX1 - b.fromX0, b.fromY1 - b.fromY0, 1);
  return real.GetError() == GL_NO_ERROR;
}

}  // namespace gluray::gl
