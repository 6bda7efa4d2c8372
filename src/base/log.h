// The log. By default only messages of level warning or above go to stderr, one line each, and only in the
// process that the user launched, not in helpers that it starts. A line is dropped if writing it would block,
// or if the host program has closed the descriptor. Any thread.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::log {

enum class Level { trace, debug, info, warning, error, off };

/// Sets the level and the destination: appends to `file`, or writes to stderr if it is empty.
void configure(Level level, std::string_view file);

/// Whether messages of this level are written.
bool enabled(Level level) noexcept;

/// Writes one line "gluray: MESSAGE", with control characters escaped, if `level` is enabled. Never throws.
void write(Level level, std::string_view message) noexcept;

/// Writes `message` unless one with the same `key` was written before.
void once(Level level, std::string_view key, std::string_view message) noexcept;

/// Shows a line that the next status or message replaces; empty: removes it. Only where warnings go to
/// standard error and that is a terminal. Never throws.
void status(std::string_view line) noexcept;

/// Makes `run` write the lines of the calling thread: it calls its argument on another thread and waits for
/// it. For threads with a descriptor table of their own. Null: the calling thread writes.
using Run = void (*)(const std::function<void()>& write);
void writeBy(Run run) noexcept;

/// The last kRecent messages at level warning or above, oldest first, as far as memory allowed, including
/// those that configure() excludes from the log. Long messages are cut.
inline constexpr int kRecent = 20;
std::vector<std::string> recent();

}  // namespace gluray::log
