// gluray get -p PROGRAM and gluray get --live: values in running programs.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints the values of the settings that the command line names, or of all that differ from their built-in
/// values. Returns the exit code.
int getLiveSettings(const CommandLine& line);

}  // namespace gluray::launcher
