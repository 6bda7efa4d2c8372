// The launcher's output: messages, JSON, files. Escapes unprintable characters in messages.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::launcher {

/// Writes one line "gluray: TEXT" to stderr. Drops it if nobody reads stderr.
void say(const std::string& text);
/// Indented JSON; replaces invalid UTF-8.
std::string jsonText(const nlohmann::json& value);
/// Writes a file (base/files.h). Throws std::runtime_error with one line if it cannot.
void writeFile(const std::string& path, const std::string& text);

}  // namespace gluray::launcher
