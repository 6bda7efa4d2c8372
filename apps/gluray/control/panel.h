// gluray panel: becomes gluray-panel, which is a program of its own so that the launcher needs no Qt.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Returns only if the panel cannot be started: the exit code.
int openPanel(const CommandLine& line);

}  // namespace gluray::launcher
