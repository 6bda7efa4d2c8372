#include "gl/framebuffers/antialiased_image.h"

#include "gl/batch/clears.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {
namespace {

GLuint asked(const RealGl& real, GLenum name) { return static_cast<GLuint>(integer(real, name)); }

}  // namespace

void AntialiasedImage::clear(const RealGl& real, const RareState& has) {
  texture_ = 0;
  const GLuint framebuffer = drawFramebuffer(real);
  const GLenum buffer = framebuffer ? asked(real, GL_DRAW_BUFFER0) : GLenum{GL_NONE};
  const glm::ivec4 box = scissorBox(real);
  const scene::Region region{box.x, box.y, box.z, box.w};
  if (isOf(framebuffer, buffer) && contains(region_, region)) return;
  *this = {};
  if (framebuffer == 0 || !clearsInFull(real, has, GL_COLOR_BUFFER_BIT)) return;
  framebuffer_ = framebuffer, buffer_ = buffer, region_ = region;
}

void AntialiasedImage::wrote(GLuint framebuffer, GLenum buffer) {
  texture_ = 0;
  if (!isOf(framebuffer, buffer)) *this = {};
}

void AntialiasedImage::send(const RealGl& real, const TextureCache& textures, GLenum target) {
  if (!any()) return;
  const GLuint texture = target == GL_TEXTURE_2D ? asked(real, GL_TEXTURE_BINDING_2D) : 0;
  if (texture == 0 || textures.mayBeAttached(texture)) *this = {};
  if (texture == texture_) texture_ = 0;
}

void AntialiasedImage::copy(const RealGl& real, GLenum target, GLint level, glm::ivec2 offset,
                            const scene::Region& from) {
  if (!any() || target != GL_TEXTURE_2D || level != 0 || offset != glm::ivec2(0)) return;
  if (!isOf(asked(real, GL_READ_FRAMEBUFFER_BINDING), asked(real, GL_READ_BUFFER)) ||
      !isOf(asked(real, GL_DRAW_FRAMEBUFFER_BINDING), asked(real, GL_DRAW_BUFFER0)))
    return;
  texture_ = asked(real, GL_TEXTURE_BINDING_2D), copied_ = from;
}

bool AntialiasedImage::isCopy(GLuint texture, const scene::Region& region, GLuint framebuffer,
                              GLenum buffer) const {
  return copied() && texture_ == texture && copied_ == region && isOf(framebuffer, buffer) &&
         contains(region_, region);
}

}  // namespace gluray::gl
