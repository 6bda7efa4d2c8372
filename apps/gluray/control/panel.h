// gluray panel: becomes gluray-panel, which is a program of its own so that the launcher needs no Qt.
#pragma once
#include "command_line.h"

#include <string>
#include <vector>

namespace gluray::launcher {

/// Becomes gluray-panel with these words. Returns only if it cannot be started: the exit code.
int becomePanel(std::vector<std::string> words);

/// Returns only if the panel cannot be started: the exit code.
int openPanel(const CommandLine& line);

}  // namespace gluray::launcher
