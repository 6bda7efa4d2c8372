// gluray doctor: checks this machine, this install and a program without starting the program; or a job of
// workers.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints the findings. Returns Diagnosis::exitCode().
int doctor(const CommandLine& line);

}  // namespace gluray::launcher
