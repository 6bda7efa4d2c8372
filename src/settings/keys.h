// The settings by name, as the environment and the configuration file give them. GL thread, once a process.
#pragma once
#include "settings/settings.h"

#include <span>
#include <string>
#include <string_view>

namespace gluray {

/// The names: "threads", "bvh", "log-level" ... ; GLURAY_LOG_LEVEL is the variable of the last.
std::span<const std::string_view> settingKeys();

/// Whether `key` is a setting that a configuration file may hold; the others belong to one run.
bool isForFiles(std::string_view key);

/// Sets what `key` names to what `value` says. Returns what would have been right ("use auto, fast, full,
/// compact or least") where the value cannot be read, and leaves the session as it was.
std::string setSetting(Session& session, std::string_view key, std::string_view value);

}  // namespace gluray
