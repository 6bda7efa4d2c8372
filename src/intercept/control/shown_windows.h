// The X windows with the program's frames: recorded on GL threads at swaps, used on the control thread.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

struct _XDisplay;  // Xlib's Display, without its header's macros

namespace gluray::intercept {

struct ShownWindow {
  std::string display;  // name of the X server
  uint32_t window = 0;
  bool operator==(const ShownWindow&) const = default;
};

/// Call when a swap has shown a frame in a GLX drawable; for the first window leaves the file by which hubs
/// find this program. Costs a comparison while swaps show the same drawable.
void noteShown(_XDisplay* display, uintptr_t drawable) noexcept;

/// The same for EGL. Call when a surface was made of the native window, which is an X window if its number
/// may be one, and when it goes. Whether it is one on the server of DISPLAY turns out when it is asked for.
void noteSurface(const void* surface, uint64_t window) noexcept;
void forgetSurface(const void* surface) noexcept;
void noteShownSurface(const void* surface) noexcept;

/// The windows in which frames were shown, last first; they may be gone.
std::vector<ShownWindow> shownWindows();
/// Forgets a window that is gone.
void forgetShown(const ShownWindow& window);

}  // namespace gluray::intercept
