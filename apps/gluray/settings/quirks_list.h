// gluray quirks: lists the workarounds.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints each workaround with its reason and test. Returns the exit code.
int listQuirks(const CommandLine& line);

}  // namespace gluray::launcher
