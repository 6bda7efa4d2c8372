// Values of settings as text: how files, variables and options have them. Any thread.
#pragma once
#include "settings/rows.h"

#include <string>
#include <string_view>

namespace gluray {

/// Which texts the setting takes: "auto, fast, full, compact or least". Empty: any.
std::string allowedValues(const Row& row);

/// Sets the value that `text` says. Returns what would have been right ("use auto, fast, full, compact or
/// least") where the text cannot be read, and leaves the session as it was.
std::string readValue(const Row& row, std::string_view text, Session& session);

/// The value as text, from which readValue() makes the same value.
std::string printValue(const Row& row, const Session& session);

/// Whether both sessions have the same value.
bool sameValue(const Row& row, const Session& a, const Session& b);

/// Gives `next` the values of `old` for all settings that do not apply to single frames.
void keepBetweenFrames(Settings& next, const Settings& old);

}  // namespace gluray
