// gluray environment: the variables that gluray PROGRAM would set, for shells, batch jobs and processes that
// run already.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints the variables as commands of a shell or, with --json, as an object {"variables", "libraries",
/// "program"}: by a process that runs already, "libraries" are to be loaded for all (RTLD_GLOBAL) before its
/// first window. Returns the exit code.
int printEnvironment(const CommandLine& line);

}  // namespace gluray::launcher
