// gluray presets: the presets, and their values.
#pragma once
#include "command_line.h"

#include <string>

namespace gluray::launcher {

int listPresets(const CommandLine& line);

/// Error line about the option --preset; empty: there is such a preset, or no such option.
std::string wrongPreset(const CommandLine& line);

}  // namespace gluray::launcher
