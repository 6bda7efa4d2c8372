// gluray camera: the cameras of running programs, and their lens.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Lists the cameras, changes settings of the group camera, or focuses on a point. Returns the exit code: 1
/// if a program refuses or nothing is there, 2 if a word is wrong.
int changeCamera(const CommandLine& line);

}  // namespace gluray::launcher
