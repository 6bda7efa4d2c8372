// gluray settings: what is set, and by whom.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

int listSettings(const CommandLine& line);

}  // namespace gluray::launcher
