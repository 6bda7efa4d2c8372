// gluray explain: runs a program for some frames and prints which of its draws were traced or why not.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Returns the exit code: 0, 1 if GLuRay saw no OpenGL context of the program, 126 and 127 as for running it.
int explain(const CommandLine& line);

}  // namespace gluray::launcher
