// Adds the launcher's options for settings, from the table of settings.
#pragma once
#include "settings/chosen_settings.h"

#include <CLI/CLI.hpp>

#include <string>

namespace gluray::launcher {

/// Adds --set and the options of single settings; for `explain`, without those that it sets itself.
void addSettingOptions(CLI::App& app, ChosenSettings& chosen, bool explain);

/// One line that says what is wrong with "NAME=VALUE"; empty: nothing.
std::string problemOfPair(const std::string& pair);

}  // namespace gluray::launcher
