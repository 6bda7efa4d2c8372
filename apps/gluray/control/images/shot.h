// gluray shot: saves the image of a running program's window as PNG.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Returns the exit code: 1 if the program has no image or the file cannot be written, 2 if the file's name
/// is wrong or something else than a PNG file stands there.
int saveShot(const CommandLine& line);

}  // namespace gluray::launcher
