// The X windows that show the program's frames: recorded on GL threads at swaps, used on the control thread.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

struct _XDisplay;  // Xlib's Display, without its header's macros

namespace gluray::intercept {

struct ShownWindow {
  std::string display;  // name of the X display
  uint32_t window = 0;
  bool operator==(const ShownWindow&) const = default;
};

/// Call when a swap has shown a frame in a GLX drawable. For the first window, writes the file by which hubs
/// find this program. While swaps show the same drawable, it costs a comparison.
void noteShown(_XDisplay* display, uintptr_t drawable) noexcept;

/// Call when an EGL surface was created for a native window, which may be an X window if its number is a
/// valid id. Whether it is a window on the server of DISPLAY is checked when the window is used.
void noteSurface(const void* surface, uint64_t window) noexcept;
/// Call when an EGL surface is destroyed.
void forgetSurface(const void* surface) noexcept;
/// Like noteShown(), for an EGL surface.
void noteShownSurface(const void* surface) noexcept;

/// The windows in which frames were shown, last first; some may not exist any more.
std::vector<ShownWindow> shownWindows();
/// Forgets a window that does not exist any more.
void forgetShown(const ShownWindow& window);

}  // namespace gluray::intercept
