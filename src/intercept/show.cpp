#include "intercept/show.h"

#include "intercept/context_record.h"
#include "intercept/session.h"

namespace gluray::intercept {
namespace {

WindowPut* putInto(_XDisplay* display, uintptr_t drawable, WindowOfContext& window) {
  if (window.drawable != drawable || (window.put && !window.put->isFor(display, drawable))) {
    if (window.put) window.put->close();
    window.put = WindowPut::create(display, drawable);
    window.drawable = drawable;
  }
  return window.put.get();
}

bool show(_XDisplay* display, uintptr_t drawable, Record& record) {
  WindowPut* const put = putInto(display, drawable, record.window);
  if (!put) return false;
  const glm::ivec2 size = put->size();
  if (size.x > 0 &&
      record.context->showDirectly(size, [&](const gl::ShownPicture& p) { return put->put(p); }))
    return true;
  if (size.x == 0) record.window.put.reset();  // not tried again
  return false;
}

}  // namespace

bool shownDirectly(_XDisplay* display, uintptr_t drawable) noexcept {
  bool shown = false;
  if (session().picture || session().hud) return false;
  Record* const record = current().record.get();
  if (!record || !record->context || record->context.get() != gl::t_thread.context ||
      current().drawables.draw != drawable || current().drawables.read != drawable ||
      !record->context->info().doubleBuffered)
    return false;
  guarded("cannot show a picture", [&] {
    if (!record->context->mayShowDirectly() || !show(display, drawable, *record)) return;
    shown = true;
    record->context->completeFrame();
  });
  return shown;
}

}  // namespace gluray::intercept
