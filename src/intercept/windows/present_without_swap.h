// Shows frames without a swap of the real OpenGL. Called on the thread in which the context is current.
#pragma once
#include "intercept/windows/shm_window.h"

#include <cstdint>
#include <memory>

namespace gluray::intercept {

/// The window into which a context's pictures go.
struct WindowOfContext {
  uintptr_t drawable = 0;  // the last one tried
  std::unique_ptr<ShmWindow> put;
  glm::ivec2 swapped{0};  // size of the window at the last swap by the real OpenGL that is known
  uintptr_t sized = 0;    // the drawable whose size it is; 0: none
  int swapsBefore = 0;    // by the real OpenGL, before the first picture was tried
  /// Whether the real OpenGL knows the window's size: it updates its buffers' size only after a swap. False:
  /// let it make this swap.
  bool isKnown(glm::ivec2 size) {
    const bool known = size == swapped && size.x > 0;
    swapped = size;
    return known;
  }
};

/// GLX created, or destroyed, a GLX name of an X window. Any thread.
void glxWindowMade(uintptr_t name, uintptr_t window) noexcept;
void glxWindowGone(uintptr_t name) noexcept;
/// The X server's name of a GLX drawable.
uintptr_t windowOf(uintptr_t drawable) noexcept;
/// The ShmWindow of the drawable; null if it is not supported. On the thread of the window's context.
ShmWindow* shmWindowFor(_XDisplay* display, uintptr_t drawable, WindowOfContext& window);

/// Call before a swap of `drawable`. True: the frame has been shown; skip the swap.
bool shownDirectly(_XDisplay* display, uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
