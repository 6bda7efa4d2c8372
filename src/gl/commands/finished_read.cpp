#include "gl/commands/finished_read.h"

#include "gl/context/handlers.h"

namespace gluray::gl {

void FinishedRead::bind(const scene::Region& region, GLenum format) noexcept {
  if (flushToRead(format) != Context::Flush::read || context_.clock.passesThrough() ||
      context_.failsafe.aside() || context_.clock.animates())
    return;
  context_.protect([&] {
    const PresentResult result = context_.pending.presenter.reader().bindFinished(context_.real, region);
    context_.pending.takeResult(result, true);
    bound_ = result.outcome == PresentResult::traced;
  });
}

void FinishedRead::unbind() noexcept { context_.pending.presenter.reader().unbindFinished(context_.real); }

}  // namespace gluray::gl
