// The log. By default only messages of level warning or above go to stderr, one line each, and only in the
// process that the user launched, not in helpers that it starts. A line is dropped if writing it would block,
// or if the host program has closed the descriptor. Any thread.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gluray::log {

enum class Level { trace, debug, info, warning, error, off };

/// Sets the level and the destination: appends to `file`, or writes to stderr if it is empty.
void configure(Level level, std::string_view file);

/// Writes one line "gluray: MESSAGE", with control characters escaped, if `level` is enabled. Never throws.
void write(Level level, std::string_view message) noexcept;

/// Writes `message` unless one with the same `key` was written before.
void once(Level level, std::string_view key, std::string_view message) noexcept;

/// The last kRecent messages at level warning or above, oldest first, as far as memory allowed; also those
/// that configure() keeps from being written. Long ones are cut.
inline constexpr int kRecent = 20;
std::vector<std::string> recent();

}  // namespace gluray::log
