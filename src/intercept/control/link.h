// The process's link to the hub: src/control implements the protocol, this folder the program's side. Any
// thread.
#pragma once
#include "intercept/control/shown_windows.h"

namespace gluray {
class LiveSettings;
}

namespace gluray::intercept {

/// Call once, when the session has been read and before frames are drawn. `live` must live forever. Without
/// this call nothing is done.
void allowControl(LiveSettings& live) noexcept;
/// Whether allowControl() was called.
bool mayBeControlled() noexcept;

/// Call when a frame begins: looks for a hub now and then. `now`: nowSeconds().
void lookForHub(double now) noexcept;

/// Leaves the file by which hubs find this program, once; with a window, also where one without was left.
void leaveFile(const ShownWindow& window = {}) noexcept;

/// Call in the child of a fork.
void leaveHubToParent() noexcept;

}  // namespace gluray::intercept
