#include "intercept/frames/direct_swap.h"

#include "intercept/capture/capture.h"
#include "intercept/contexts/context_record.h"
#include "intercept/session/guarded.h"
#include "intercept/session/session.h"
#include "intercept/window_systems/drawable_size.h"
#include "intercept/windows/glx_windows.h"
#include "intercept/windows/window_images.h"

namespace gluray::intercept {
namespace {

bool show(_XDisplay* display, uintptr_t drawable, RealSwap swap, Record& record) {
  WindowOfContext& window = record.window;
  ShmWindow* const put = shmWindowFor(display, drawable, window);
  if (!put) return false;
  gl::WindowFrames& frames = record.context->window;
  if (!frames.holdsFrame()) window.frameSize = {0, 0};
  const glm::ivec2 size = window.size();
  if (size.x == 0) return window.put.reset(), false;  // do not try again
  window.realSwap = [=] { swap(display, drawable); };
  const auto shows = [&](const gl::ShownImage& image) {
    if (size != window.swapped) {
      window.swapped = size;
      window.swapAlone();  // the image follows
    }
    if (!put->put(image, size)) return false;
    window.frameSize = {0, 0};
    keepShownImage(image, size, ShownFrame::now);
    return true;
  };
  return (frames.holdsFrame() || window.isKnown(size)) && frames.showWithoutSwap(window, size, shows);
}

/// Call before a swap by the real OpenGL that precedes the context's first image: remembers the window's
/// size, so that the image may be shown directly. Programs show a few empty frames first. After more than
/// kMax of them the size stays unknown, because a query costs a round trip.
void noteEmptySwap(_XDisplay* display, uintptr_t drawable, Record& record) {
  constexpr int kMax = 8;
  WindowOfContext& window = record.window;
  gl::ShadowState& shadow = record.context->shadow;
  if (window.drawable != 0 || window.swapsBefore > kMax || shadow.info.off ||
      !shadow.settings.quirks.has(Quirk::softwareShow) || !shadow.isSoftwareBelow())
    return;
  window.sized = windowOf(drawable);
  window.swapped = ++window.swapsBefore > kMax ? glm::ivec2(0) : drawableSize(display, drawable);
}

}  // namespace

bool shownDirectly(_XDisplay* display, uintptr_t drawable, RealSwap swap) noexcept {
  bool shown = false;
  if (session().picture || session().hud || capturing()) return false;
  Record* const record = current().record.get();
  if (!record || !record->context || record->context.get() != gl::t_thread.context ||
      current().drawables.draw != drawable || current().drawables.read != drawable ||
      !record->context->info().doubleBuffered)
    return false;
  guarded("cannot show an image", [&] {
    if (!record->context->frames.mayShowDirectly()) return noteEmptySwap(display, drawable, *record);
    if (!show(display, drawable, swap, *record)) return;
    shown = true;
    record->context->passthrough.stopMeasuring();
  });
  return shown;
}

}  // namespace gluray::intercept
