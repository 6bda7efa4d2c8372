#include "intercept/windows/window_of_context.h"

#include "base/timeline.h"
#include "intercept/session/guarded.h"
#include "intercept/window_systems/real_functions.h"
#include "intercept/windows/glx_windows.h"
#include "intercept/windows/idle_window_of_context.h"

#include <utility>

namespace gluray::intercept {

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

}  // namespace gluray::intercept
