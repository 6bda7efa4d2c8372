// gluray report-bug: packs what a bug report needs into an archive. One thread.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Runs the program, if one is given, and writes the archive `line.archive`. Returns the exit code.
int reportBug(const CommandLine& line);

}  // namespace gluray::launcher
