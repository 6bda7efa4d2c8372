// gluray hub: runs the hub alone (docs/control-protocol.md), or writes a key file for it.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Runs until SIGINT or SIGTERM, or (--with-parent) the end of standard input. The exit code: 1 where it
/// cannot, such as where another hub runs.
int runHub(const CommandLine& line);

}  // namespace gluray::launcher
