// Options of settings, made from their table.
#pragma once
#include "settings/chosen_settings.h"

#include <CLI/CLI.hpp>

namespace gluray::launcher {

/// --set, and the options that settings have of their own; for `explain` without those that it chooses.
void addSettingOptions(CLI::App& app, ChosenSettings& chosen, bool explain);

}  // namespace gluray::launcher
