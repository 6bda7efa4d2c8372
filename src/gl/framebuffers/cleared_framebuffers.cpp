#include "gl/framebuffers/cleared_framebuffers.h"

#include "gl/batch/clears.h"
#include "gl/real/state_queries.h"
#include "settings/samples.h"

#include <GL/glext.h>

namespace gluray::gl {

void ClearedFramebuffers::clear(GLbitfield mask) {
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  const RealGl& real = shadow_.real;
  forgetClear();
  if (mask & GL_COLOR_BUFFER_BIT && samplesPerPixel(shadow_.settings) > 1 && !clock_.passesThrough())
    antialiased_.clear(real, shadow_.rare());
  if ((mask & kBoth) != kBoth || clock_.passesThrough() || failsafe_.aside() || shadow_.activeQueries > 0 ||
      !shadow_.isSoftwareBelow())
    return;
  const GLuint framebuffer = drawFramebuffer(real);
  const Quirk use = framebuffer == 0 ? Quirk::softwareShow : Quirk::softwarePut;
  if (!shadow_.settings.quirks.has(use) || !clearsAll(real, shadow_.rare())) return;
  const glm::ivec4 box = scissorBox(real);
  ClearedTarget cleared{framebuffer, {box.x, box.y, box.z, box.w}, {}};
  real.GetFloatv(GL_COLOR_CLEAR_VALUE, cleared.color.data());
  cleared_ = cleared;
  // The upload waits for the clear. After a flush, llvmpipe's threads make it while the program prepares its
  // draws.
  if (framebuffer != 0 && uploads_) real.Flush();
}

/// Whether the draw framebuffer's attachment has eight linear bits in each channel. Images assume one cleared
/// pixel value for each colour.
bool ClearedFramebuffers::holdsBytes(GLenum drawBuffer) const {
  const auto value = [&](GLenum name) {
    return attachmentValue(shadow_.real, GL_DRAW_FRAMEBUFFER, drawBuffer, name);
  };
  return value(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 8 && value(GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE) == 8 &&
         value(GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE) == 8 &&
         value(GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE) == 8 &&
         value(GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_LINEAR;
}

std::optional<ClearedTarget> ClearedFramebuffers::under(const scene::Snapshot& snapshot,
                                                        const BatchKey& key) const {
  if (!cleared_ || key.framebuffer == 0 || key.framebuffer != cleared_->framebuffer ||
      key.depthFunc != GL_LEQUAL || key.layers != BatchKey::Layers::none || snapshot.samples != 1 ||
      !key.colorWrites.all() || key.encodes || shadow_.group.stencilsSet ||
      !contains(cleared_->region, snapshot.region) || !holdsBytes(key.drawBuffer) ||
      shadow_.images.mayBeDeleted(shadow_.real, GL_DRAW_FRAMEBUFFER, key.drawBuffer) ||
      shadow_.images.mayBeDeleted(shadow_.real, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT))
    return std::nullopt;
  return cleared_;
}

void ClearedFramebuffers::wroteAntialiased(const AntialiasedImage& before, const BatchKey& key) {
  antialiased_ = before;
  antialiased_.wrote(key.framebuffer, key.drawBuffer);
}

void ClearedFramebuffers::drawing(bool smaller, bool larger) {
  cleared_.reset(), antialiased_ = {};
  if (larger) ++depthEpochs_[0];
  if (smaller) ++depthEpochs_[1];
}

void ClearedFramebuffers::imageSent(GLenum target) {
  forgetClear();
  antialiased_.send(shadow_.real, shadow_.textures, target);
}

void ClearedFramebuffers::imageCopied(GLenum target, GLint level, glm::ivec2 offset,
                                      const scene::Region& from) {
  antialiased_.copy(shadow_.real, target, level, offset, from);
}

}  // namespace gluray::gl
