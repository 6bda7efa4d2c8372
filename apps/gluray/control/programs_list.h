// gluray list: the programs that run under GLuRay.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints a line a program. Returns the exit code. Throws where no program runs.
int listPrograms(const CommandLine& line);

}  // namespace gluray::launcher
