// Adds the launcher's options for settings, from the table of settings.
#pragma once
#include "settings/chosen_settings.h"

#include <CLI/CLI.hpp>

namespace gluray::launcher {

/// Adds --set and the options of single settings; for `explain`, without those that it sets itself.
void addSettingOptions(CLI::App& app, ChosenSettings& chosen, bool explain);

}  // namespace gluray::launcher
