#include "gl/commands/finished_read.h"

#include "gl/context/handlers.h"

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

void FinishedRead::begin(const scene::Region& region, GLenum format) noexcept {
  if (flushToRead(format) != Context::Flush::read || context_.failsafe.aside()) return;
  context_.protect([&] {
    if (isPicture(context_.real, region)) context_.relighting.finish(Relighting::Place::read);
  });
  if (context_.shadow.settings.changesImage() && !context_.clock.passesThrough() &&
      !context_.clock.animates())
    bind(region);
}

void FinishedRead::bind(const scene::Region& region) noexcept {
  context_.protect([&] {
    const PresentResult result = context_.pending.presenter.reader().bindFinished(context_.real, region);
    context_.pending.takeResult(result, true);
    bound_ = result.outcome == PresentResult::traced;
  });
}

void FinishedRead::unbind() noexcept { context_.pending.presenter.reader().unbindFinished(context_.real); }

}  // namespace gluray::gl
