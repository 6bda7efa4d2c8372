// Parses the user's TOML files. Any thread.
#pragma once
#include <toml++/toml.h>

#include <string_view>

namespace gluray {

/// Like toml::parse(), but also correct for texts whose table headers have no key, which toml++ 3.3 assumes
/// to be impossible. Throws toml::parse_error.
toml::table parseToml(std::string_view text, std::string_view file = {});

}  // namespace gluray
