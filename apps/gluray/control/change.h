// gluray set, unset, preset, undo and redo: change settings of running programs.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// set, unset, preset. Prints what counts from which frame on, program by program. Returns the exit code: 1
/// if a program refused, 2 if a name or a value is wrong.
int changeSettings(const CommandLine& line);

/// undo, redo.
int stepBackOrForth(const CommandLine& line);

}  // namespace gluray::launcher
