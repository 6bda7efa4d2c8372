// Frames that are shown without a swap of the real OpenGL's. The thread that the context is current in.
#pragma once
#include "intercept/windows/shm_window.h"

#include <cstdint>
#include <memory>

namespace gluray::intercept {

/// How a context's pictures get into its window.
struct WindowOfContext {
  uintptr_t drawable = 0;  // that was tried
  std::unique_ptr<ShmWindow> put;
  glm::ivec2 swapped{0};  // size of the window at the last swap that the real OpenGL had to make
  /// Whether the real OpenGL knows a window of that size: it looks after a swap alone, and would go on with
  /// buffers of another size. False: it is to make this swap.
  bool isKnown(glm::ivec2 size) {
    const bool known = size == swapped && size.x > 0;
    swapped = size;
    return known;
  }
};

/// GLX has given a window of the X server another name, which then goes. Any thread.
void glxWindowMade(uintptr_t name, uintptr_t window) noexcept;
void glxWindowGone(uintptr_t name) noexcept;
/// The X server's name of a drawable of GLX.
uintptr_t windowOf(uintptr_t drawable) noexcept;
/// What puts pictures into the drawable; null where nothing can. Of the window's context's thread.
ShmWindow* shmWindowFor(_XDisplay* display, uintptr_t drawable, WindowOfContext& window);

/// Before a swap of `drawable`: true where the frame has been shown, and the swap is not to be made.
bool shownDirectly(_XDisplay* display, uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
