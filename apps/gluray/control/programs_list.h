// gluray list: the programs that run under GLuRay.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints a line a program. Returns the exit code: 1 where there is none.
int listPrograms(const CommandLine& line);

}  // namespace gluray::launcher
