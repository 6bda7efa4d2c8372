// gluray run --shot: runs a program, and makes pictures of the scenes that it saves meanwhile. One thread.
#pragma once
#include "command_line.h"
#include "programs/program.h"

namespace gluray::launcher {

/// Returns the exit code: that of the program, or 1 if a picture is missing.
int runWithShots(const CommandLine& line, const Program& program);

}  // namespace gluray::launcher
