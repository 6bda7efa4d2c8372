// gluray light: the lights of running programs.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Lists the lights, changes settings of the group lights, or puts the key light's highlight at a point.
/// Returns the exit code: 1 if a program refuses or nothing is there, 2 if a word is wrong.
int changeLights(const CommandLine& line);

}  // namespace gluray::launcher
