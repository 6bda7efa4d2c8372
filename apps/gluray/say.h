// What the launcher tells and writes. Names and words of others are made printable first.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::launcher {

/// Writes one line "gluray: TEXT" to stderr.
void say(const std::string& text);
/// JSON for people and programs; what is no UTF-8 is replaced.
std::string jsonText(const nlohmann::json& value);
/// Writes a file (base/files.h); throws std::runtime_error with one line where it cannot.
void writeFile(const std::string& path, const std::string& text);

}  // namespace gluray::launcher
