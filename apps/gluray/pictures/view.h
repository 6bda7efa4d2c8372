// gluray view: a saved scene in a window. It becomes gluray-panel, which has the window.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Returns only if there is no window: the exit code.
int viewSaved(const CommandLine& line);

}  // namespace gluray::launcher
