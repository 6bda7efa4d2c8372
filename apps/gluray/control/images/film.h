// gluray film: numbered images of the frames that a running program shows.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Returns the exit code: 1 if an image could not be had or written, 2 if a word is wrong.
int makeFilm(const CommandLine& line);

}  // namespace gluray::launcher
