#include "intercept/frames/idle_refinement.h"

#include "intercept/capture/capture.h"
#include "intercept/contexts/context_record.h"
#include "intercept/session/guarded.h"

namespace gluray::intercept {

void refineShown(_XDisplay* display, uintptr_t drawable) noexcept {
  const std::shared_ptr<Record>& record = current().record;
  if (capturing() || !record || !record->context || record->context.get() != gl::t_thread.context ||
      current().drawables.draw != drawable || !record->context->info().doubleBuffered)
    return;
  guarded("cannot refine a window", [&] {  // constructing the function below may throw
    record->context->window.refineWhileIdle([&]() -> std::shared_ptr<IdleWindow> {
      std::shared_ptr<IdleWindow> window;
      if (display) guarded("cannot refine a window", [&] { window = record->idle.open(display, drawable); });
      return window;
    });
  });
}

}  // namespace gluray::intercept
