// X windows whose images are refined while their programs are idle. Swaps of a window must be reported, so
// that an older image never replaces a newer one.
#pragma once
#include "base/idle_window.h"

#include <cstdint>
#include <memory>

struct _XDisplay;  // Xlib's Display, without its header's macros

namespace gluray::intercept {

class BackgroundWindow;

/// The window that a context's frames are refined in. GL thread.
class IdleWindowOfContext {
 public:
  /// The window behind a GLX drawable in its present state, over a separate connection. Null if that is not
  /// possible. Once the program shows anything else in it, windowChanges() makes the result unusable.
  std::shared_ptr<IdleWindow> open(_XDisplay* display, uintptr_t drawable);

 private:
  _XDisplay* display_ = nullptr;
  uintptr_t name_ = 0;
  std::shared_ptr<BackgroundWindow> window_;
};

/// Call before the program shows something else in the drawable's window. Waits while an image is being put
/// into it. Any thread; costs one comparison while no window is refined.
void windowChanges(uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
