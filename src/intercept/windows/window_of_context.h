// The window that shows a context's images without a swap by the real OpenGL. On the thread in which the
// context is current.
#pragma once
#include "gl/batch/window_presenter.h"
#include "intercept/windows/shm_window.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace gluray::intercept {

/// The window that shows a context's images.
struct WindowOfContext final : gl::ShownWindow {
  uintptr_t drawable = 0;  // the last one tried
  std::unique_ptr<ShmWindow> put;
  glm::ivec2 swapped{0};           // size of the real OpenGL's buffers, if frames bypass it; 0: unknown
  uintptr_t sized = 0;             // the drawable with that size; 0: none
  int swapsBefore = 0;             // by the real OpenGL, before the first image
  std::function<void()> realSwap;  // of the drawable
  glm::ivec2 frameSize{0};         // size for the current frame, after the answer was read
  void askSize() noexcept override;
  bool resized() noexcept override;
  /// The size at askSize(), or now if that was not called for this frame; {0, 0} if the window does not
  /// exist.
  glm::ivec2 size() noexcept;
  void swap() noexcept override;
  /// swap() without showing the last image again.
  void swapAlone() noexcept;
  /// Whether the real OpenGL knows the window's size: it updates the size of its buffers only after a swap.
  /// If not, it must make this swap.
  bool isKnown(glm::ivec2 size) {
    const bool known = size == swapped && size.x > 0;
    swapped = size;
    return known;
  }
};

/// The ShmWindow of the drawable; null if this is not supported.
ShmWindow* shmWindowFor(_XDisplay* display, uintptr_t drawable, WindowOfContext& window);

}  // namespace gluray::intercept
