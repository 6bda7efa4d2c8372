#include "intercept/present/read_back/sample_copy.h"

#include "gl/real/state_queries.h"
#include "intercept/present/state/state_guard.h"
#include "intercept/present/state/texture_growth.h"
#include "intercept/present/state/texture_names.h"

#include <GL/glext.h>

#include <array>
#include <mutex>

namespace gluray::present {
namespace {

using gl::RealGl;

struct SampleFormat {
  GLenum format, attachment;
};

constexpr std::array kSampleFormats{SampleFormat{GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT},
                                    SampleFormat{GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT},
                                    SampleFormat{GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT},
                                    SampleFormat{GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT},
                                    SampleFormat{GL_DEPTH_COMPONENT32, GL_DEPTH_ATTACHMENT},
                                    SampleFormat{GL_DEPTH_COMPONENT16, GL_DEPTH_ATTACHMENT}};

/// Into the texture, which has this format and room.
bool blitSamplesInto(const RealGl& real, const SampleCopy& copy, const scene::Region& region, glm::ivec2 to) {
  const CopyFramebuffer framebuffer(real);
  attachSamples(real, copy);
  // Mesa copies the memory of whole formats, and draws where only their depths are wanted.
  const bool stencil = kSampleFormats[copy.format].attachment == GL_DEPTH_STENCIL_ATTACHMENT;
  real.BlitFramebuffer(region.x, region.y, region.x + region.width, region.y + region.height, to.x, to.y,
                       to.x + region.width, to.y + region.height,
                       GL_DEPTH_BUFFER_BIT | (stencil ? GL_STENCIL_BUFFER_BIT : 0), GL_NEAREST);
  return takeErrors(real).empty();
}

/// Gives the texture a format and room for `size`.
bool allocateSamples(const RealGl& real, const Features& features, const SampleCopy& copy) {
  StateGuard guard(real, features);
  guard.textureMultisample(features.textureUnit, copy.texture);
  real.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, copy.samples, kSampleFormats[copy.format].format,
                             copy.size.x, copy.size.y, GL_TRUE);
  return takeErrors(real).empty();
}

}  // namespace

CopyFramebuffer::CopyFramebuffer(const RealGl& real)
    : real_(real),
      drawn_(gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING)),
      read_(gl::integer(real, GL_READ_FRAMEBUFFER_BINDING)) {
  real.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawn_));
  real.GenFramebuffers(1, &name_);
  real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, name_);
  real.DrawBuffer(GL_NONE);
}

CopyFramebuffer::~CopyFramebuffer() {
  real_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn_));
  real_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  real_.DeleteFramebuffers(1, &name_);
}

void attachSamples(const RealGl& real, const SampleCopy& copy) {
  real.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, kSampleFormats[copy.format].attachment,
                            GL_TEXTURE_2D_MULTISAMPLE, copy.texture, 0);
}

bool copySamples(const RealGl& real, const Features& features, const scene::Region& region, GLsizei samples,
                 SampleCopy& into, glm::ivec2 to) {
  StateGuard guard(real, features);
  guard.scissorOff();
  const glm::ivec2 end = to + glm::ivec2(region.width, region.height);
  if (into.texture != 0 && into.samples == samples && grownSize(into.size, end) == into.size &&
      blitSamplesInto(real, into, region, to))
    return true;
  if (into.texture == 0) {
    const std::lock_guard lock(textureNaming());
    into.texture = newTextureName(real, features);
    StateGuard bound(real, features);
    bound.textureMultisample(features.textureUnit, into.texture);
  }
  into.size = grownSize(into.size, end);
  into.samples = samples;
  for (into.format = 0; into.format < kSampleFormats.size(); ++into.format)
    if (allocateSamples(real, features, into) && blitSamplesInto(real, into, region, to)) return true;
  into.size = {}, into.format = 0;
  return false;
}

}  // namespace gluray::present
