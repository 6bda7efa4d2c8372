// gluray watch: prints what happens in running programs.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints until SIGINT, SIGTERM, the time of --seconds, or the end of the hub. Returns the exit code.
int watchPrograms(const CommandLine& line);

}  // namespace gluray::launcher
