// Chooses which lines of the log go to standard error. Any thread.
#pragma once
#include <string>

namespace gluray::log {

/// Called for each message at level warning or above before it goes to standard error; it may change the
/// message. Returns false to leave it out, but recent() has it. Any thread; it must not write to the log.
using Filter = bool (*)(std::string& message) noexcept;

/// Null: all messages are written.
void filterBy(Filter filter) noexcept;

}  // namespace gluray::log
