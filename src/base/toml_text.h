// Parses the user's TOML files. Any thread.
#pragma once
#include <toml++/toml.h>

#include <string_view>

namespace gluray {

/// toml::parse() of any text, also of one whose table headers have no key, which toml++ 3.3 takes for
/// impossible. Throws toml::parse_error.
toml::table parseToml(std::string_view text, std::string_view file = {});

}  // namespace gluray
