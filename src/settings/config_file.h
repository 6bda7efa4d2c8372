// gluray.toml: settings that a user wants in every run. The environment and the launcher's options come after
// it.
#pragma once
#include "settings/settings.h"

#include <string>

namespace gluray {

/// $GLURAY_CONFIG, or gluray/gluray.toml in $XDG_CONFIG_HOME (~/.config where that is unset). Empty: nowhere.
std::string configFile();

/// Takes over what `file` sets. What cannot be read is told through `complain`, one line each with file and
/// line number
/// ("gluray.toml:3: bvh = quick: use auto, fast, full, compact or least"), and left as it was. A file that is
/// not there is told only where `wanted`.
void readConfigFile(const std::string& file, bool wanted, Session& session,
                    void (*complain)(const std::string& line));

}  // namespace gluray
