// gluray settings: lists the settings with their values and origins.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

int listSettings(const CommandLine& line);

}  // namespace gluray::launcher
