// The process's link to the hub: src/control implements the protocol, this folder provides the program's
// side. Any thread.
#pragma once
#include "intercept/control/shown_windows.h"

namespace gluray {
class LiveSettings;
}

namespace gluray::intercept {

/// Call once, after the session was read and before frames are drawn. `live` must never be destroyed. Without
/// this call there is no link.
void allowControl(LiveSettings& live) noexcept;
/// Whether allowControl() was called.
bool mayBeControlled() noexcept;

/// Call when a frame begins: checks for a hub from time to time. `now`: nowSeconds().
void lookForHub(double now) noexcept;

/// Writes the file by which hubs find this program, once. If `window` is set, also replaces a file that was
/// written without a window.
void leaveFile(const ShownWindow& window = {}) noexcept;

/// Call in the child of a fork.
void leaveHubToParent() noexcept;

}  // namespace gluray::intercept
