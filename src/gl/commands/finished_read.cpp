#include "gl/commands/finished_read.h"

#include "gl/context/handlers.h"
#include "gl/context/stub.h"

#include <cstdint>

namespace gluray::gl {
namespace {

/// Whether so much is read as of a picture: a quarter of the viewport's pixels. Programs pick objects by
/// small reads.
bool isPicture(const RealGl& real, const scene::Region& region) {
  GLint viewport[4] = {};
  real.GetIntegerv(GL_VIEWPORT, viewport);
  return 4 * int64_t{region.width} * region.height >= int64_t{viewport[2]} * viewport[3];
}

}  // namespace

void FinishedRead::begin(GLenum format) noexcept {
  if (flushToRead(format) != Context::Flush::read || context_.failsafe.aside()) return;
  context_.protect([&] {
    isPicture_ = isPicture(context_.real, region_);
    if (isPicture_) context_.relighting.finish(Relighting::Place::read);
  });
  if (context_.shadow.settings.changesImage() && !context_.clock.passesThrough() &&
      !context_.clock.animates())
    bind();
}

void FinishedRead::bind() noexcept {
  context_.protect([&] {
    const PresentResult result = context_.pending.presenter.reader().bindFinished(context_.real, region_);
    context_.pending.takeResult(result, true);
    bound_ = result.outcome == PresentResult::traced;
  });
}

void FinishedRead::unbind() noexcept { context_.pending.presenter.reader().unbindFinished(context_.real); }

void FinishedRead::pictureRead() noexcept {
  const ContextInfo& info = context_.shadow.info;
  if (info.pictureRead) context_.protect([&] { info.pictureRead(region_); });
}

void pictureCopied(Context& c) {
  c.protect([&] { c.relighting.finish(Relighting::Place::read); });
}

void pictureCopied(Context& c, GLenum internalFormat) {
  switch (internalFormat) {
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_COMPONENT16:
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32:
    case GL_DEPTH_COMPONENT32F:
    case GL_DEPTH_STENCIL:
    case GL_DEPTH24_STENCIL8:
    case GL_DEPTH32F_STENCIL8: return;
    default: pictureCopied(c);
  }
}

void pictureCopied(Context& c, GLenum target, GLint level) {
  c.protect([&] {
    c.shadow.errors.keepPending();
    GLint depthBits = 0;
    c.real.GetTexLevelParameteriv(target, level, GL_TEXTURE_DEPTH_SIZE, &depthBits);
    c.shadow.errors.takeReal();
    if (depthBits == 0) c.relighting.finish(Relighting::Place::read);
  });
}

void imagesRead(Context& c) {
  c.protect([&] { c.relighting.finish(Relighting::Place::images); });
}

}  // namespace gluray::gl
