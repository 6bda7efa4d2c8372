// gluray render --again, gluray shot --again: repeats the command that a picture's file names.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// The command line that the file of `line.picture.repeat` says it was made by, with the file itself, or the
/// numbered files beside it, as the result, and the hashes of the scene and of the cameras that it must have.
/// Whatever the text says, only gluray's own command line is read from it. Throws std::runtime_error with one
/// line.
CommandLine repeated(const CommandLine& line);

}  // namespace gluray::launcher
