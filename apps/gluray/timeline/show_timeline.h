// `gluray timeline FILE`.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints what each thread did, and writes the chart that `line` asks for. Returns the exit code.
int showTimeline(const CommandLine& line);

}  // namespace gluray::launcher
