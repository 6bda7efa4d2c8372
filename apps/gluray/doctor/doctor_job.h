// gluray doctor --job: checks a running job of workers from a machine of the job.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints the findings. Returns Diagnosis::exitCode(), or kUsageError where no job may have the name.
int doctorJob(const CommandLine& line);

}  // namespace gluray::launcher
