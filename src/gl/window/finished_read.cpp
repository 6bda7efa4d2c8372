#include "gl/window/finished_read.h"

#include "gl/handlers.h"

namespace gluray::gl {

void FinishedRead::bind(const scene::Region& region, GLenum format) noexcept {
  if (flushToRead(format) != Context::Flush::read || context_.clock.passesThrough() ||
      context_.failsafe.aside() || context_.clock.animates())
    return;
  context_.protect([&] {
    const PresentResult result = context_.flusher.presenter.reader().bindFinished(context_.real, region);
    context_.flusher.takeResult(result, true);
    bound_ = result.outcome == PresentResult::traced;
  });
}

void FinishedRead::unbind() noexcept { context_.flusher.presenter.reader().unbindFinished(context_.real); }

}  // namespace gluray::gl
