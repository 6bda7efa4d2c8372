// gluray top: what running programs and their ranks spend, once a second.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Prints tables until it is interrupted, or one. Returns the exit code. Throws std::runtime_error with one
/// line.
int showTop(const CommandLine& line);

}  // namespace gluray::launcher
