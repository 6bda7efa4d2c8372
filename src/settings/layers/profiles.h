// The profiles of programs that GLuRay ships (spec/profiles.toml). Any thread.
#pragma once
#include "settings/layers/config_file.h"

#include <string_view>
#include <vector>

namespace gluray {

/// The settings of the program's profile, all of them valid; none if none is shipped for it.
std::vector<FileSetting> shippedProfile(std::string_view program);

/// All of the file's settings. Throws toml::parse_error.
std::vector<FileSetting> shippedProfiles();

}  // namespace gluray
