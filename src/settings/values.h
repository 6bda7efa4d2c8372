// Values of settings as text, as in files, variables and options. Any thread.
#pragma once
#include "settings/rows.h"

#include <string>
#include <string_view>

namespace gluray {

/// The texts that the setting accepts: "auto, fast, full, compact or least". Empty if it accepts any text.
std::string allowedValues(const Row& row);

/// Parses `text` into the session. If the text is not allowed, leaves the session unchanged and returns the
/// allowed values ("use auto, fast, full, compact or least"). Otherwise returns an empty string.
std::string readValue(const Row& row, std::string_view text, Session& session);

/// The value as text, from which readValue() reads the same value.
std::string printValue(const Row& row, const Session& session);

/// Whether the setting has the same value in both sessions.
bool sameValue(const Row& row, const Session& a, const Session& b);

/// Copies from `old` to `next` all settings that may not change between frames of a context.
void keepBetweenFrames(Settings& next, const Settings& old);

}  // namespace gluray
