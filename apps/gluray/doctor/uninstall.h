// gluray uninstall: what GLuRay keeps outside its own folder, and how to remove GLuRay itself.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Lists the user's settings and runtime directories; with --remove, removes them. Returns the exit code.
int uninstall(const CommandLine& line);

}  // namespace gluray::launcher
