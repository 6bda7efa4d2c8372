// Makes programs that wait for something draw a frame.
#pragma once
#include <string>

namespace gluray {

/// Asks the X server to expose the window, so that its program draws it again. Returns at once; ignores
/// errors. Windows are woken one after the other. Any thread.
void wakeWindow(const std::string& display, unsigned long window);

/// Whether the X server answers. It does not where libxcb is missing.
bool canReach(const std::string& display);

}  // namespace gluray
