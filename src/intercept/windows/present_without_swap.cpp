#include "intercept/windows/present_without_swap.h"

#include "base/never_destroyed.h"
#include "base/timeline.h"
#include "intercept/context_record.h"
#include "intercept/control/window_pictures.h"
#include "intercept/session.h"
#include "intercept/window_systems/drawable_size.h"
#include "intercept/window_systems/real_functions.h"
#include "intercept/windows/x_idle_window.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <utility>

namespace gluray::intercept {
namespace {

struct Names {
  std::mutex mutex;
  std::map<uintptr_t, uintptr_t> windows;
};
Names& names() {
  static NeverDestroyed<Names> all;
  return *all;
}

}  // namespace

ShmWindow* shmWindowFor(_XDisplay* display, uintptr_t drawable, WindowOfContext& window) {
  const uintptr_t shown = windowOf(drawable);
  if (window.drawable != shown || (window.put && !window.put->isFor(display, shown))) {
    if (window.put) window.put->close();
    if (window.drawable != 0 || window.sized != shown) window.swapped = {0, 0};
    window.put = ShmWindow::create(display, shown);
    window.drawable = window.sized = shown;
  }
  return window.put.get();
}

void WindowOfContext::askSize() noexcept {
  frameSize = {0, 0};
  if (put) put->askSize();
}

glm::ivec2 WindowOfContext::size() noexcept {
  if (frameSize.x == 0 && put) frameSize = put->size();
  return frameSize;
}

bool WindowOfContext::resized() noexcept {
  const glm::ivec2 now = size();
  return now.x > 0 && now != std::exchange(swapped, now);
}

void WindowOfContext::swap() noexcept {
  swapAlone();
  if (put) put->putAgain();
}

void WindowOfContext::swapAlone() noexcept {
  guarded("cannot swap", [&] {
    const Outermost nested;
    const timeline::Span span("swap");
    windowChanges(drawable);
    realSwap();
  });
}

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
  const auto shows = [&](const gl::ShownPicture& picture) {
    if (size != window.swapped) {
      window.swapped = size;
      window.swapAlone();  // the picture follows
    }
    if (!put->put(picture, size)) return false;
    window.frameSize = {0, 0};
    keepShownPicture(picture, size, ShownFrame::now);
    return true;
  };
  return (frames.holdsFrame() || window.isKnown(size)) && frames.showWithoutSwap(window, size, shows);
}

/// Before a swap by the real OpenGL that comes before the context's first picture: remembers the window's
/// size, so that the picture may be shown directly. Programs show a few empty frames first. After more of
/// them the size is unknown, because asking costs a round trip.
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

void glxWindowMade(uintptr_t name, uintptr_t window) noexcept {
  guarded("cannot remember a window", [&] {
    const std::lock_guard lock(names().mutex);
    names().windows[name] = window;
  });
}

void glxWindowGone(uintptr_t name) noexcept {
  const std::lock_guard lock(names().mutex);
  names().windows.erase(name);
}

uintptr_t windowOf(uintptr_t drawable) noexcept {
  const std::lock_guard lock(names().mutex);
  const auto known = names().windows.find(drawable);
  return known == names().windows.end() ? drawable : known->second;
}

bool shownDirectly(_XDisplay* display, uintptr_t drawable, RealSwap swap) noexcept {
  bool shown = false;
  if (session().picture || session().hud) return false;
  Record* const record = current().record.get();
  if (!record || !record->context || record->context.get() != gl::t_thread.context ||
      current().drawables.draw != drawable || current().drawables.read != drawable ||
      !record->context->info().doubleBuffered)
    return false;
  guarded("cannot show a picture", [&] {
    if (!record->context->frames.mayShowDirectly()) return noteEmptySwap(display, drawable, *record);
    if (!show(display, drawable, swap, *record)) return;
    shown = true;
    record->context->passthrough.stopMeasuring();
  });
  return shown;
}

}  // namespace gluray::intercept
