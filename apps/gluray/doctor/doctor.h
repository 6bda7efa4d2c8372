// gluray doctor: what will work, before anything is started.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints what was found; the exit code is Diagnosis::exitCode().
int doctor(const CommandLine& line);

}  // namespace gluray::launcher
