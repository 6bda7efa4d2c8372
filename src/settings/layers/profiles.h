// The profiles of programs that GLuRay ships (spec/profiles.toml). Any thread.
#pragma once
#include "settings/layers/config_file.h"

#include <string_view>
#include <vector>

namespace gluray {

/// The settings of the program's shipped profile, all of them valid; empty if there is none.
std::vector<FileSetting> shippedProfile(std::string_view program);

/// All settings in the shipped file. Throws toml::parse_error.
std::vector<FileSetting> shippedProfiles();

}  // namespace gluray
