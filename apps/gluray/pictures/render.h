// gluray render: a picture of a saved scene.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Returns the exit code.
int renderSaved(const CommandLine& line);

}  // namespace gluray::launcher
