// gluray settings and gluray get: settings with their values and origins.
#pragma once
#include "command_line.h"
#include "settings/layers/settings_layers.h"

namespace gluray::launcher {

int listSettings(const CommandLine& line);
int getSettings(const CommandLine& line);

/// The inputs of the layers of a program that `gluray` would start here with these options.
Sources sourcesOf(const CommandLine& line);

}  // namespace gluray::launcher
