// Settings of one group by short names: "azimuth=30" of gluray light is lights.azimuth = 30.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace gluray::launcher {

struct ShortNames {
  std::string_view group;  // "lights": names are lights.NAME, and lights itself where it is a setting
  std::string_view self;   // the short name of that setting, such as rig; empty: it has none
};

/// Adds the values of "NAME=VALUE" words to `values`, by the settings' own names. Empty, or one line that
/// says what is wrong.
std::string readShortPairs(const ShortNames& names, const std::vector<std::string>& pairs,
                           nlohmann::json& values);

}  // namespace gluray::launcher
