// The one log. Silent unless asked: messages of level warning or worse go to stderr, one line each, only in
// the process that the user launched (never in helpers that it starts). Any thread.
#pragma once
#include <string_view>

namespace gluray::log {

enum class Level { trace, debug, info, warning, error, off };

/// What is written from now on. `file` empty: stderr. To a file it is appended.
void configure(Level level, std::string_view file);

/// Writes one line "gluray: MESSAGE", controls escaped, if `level` is wanted. Never throws.
void write(Level level, std::string_view message) noexcept;

/// Writes `message` the first time only; `key` says which messages are the same.
void once(Level level, std::string_view key, std::string_view message) noexcept;

}  // namespace gluray::log
