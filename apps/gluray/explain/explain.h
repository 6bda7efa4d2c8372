// gluray explain: runs a program for some frames and says what became of its draws.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Returns the exit code: 0 where there is something to tell, 1 where the program made no OpenGL context that
/// GLuRay could see, 126 and 127 as for running it.
int explain(const CommandLine& line);

}  // namespace gluray::launcher
