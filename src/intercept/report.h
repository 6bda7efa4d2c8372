// The report at exit: what was traced, what was not and why, and what it cost. Registered with atexit by the
// engine.
#pragma once

namespace gluray::intercept {

/// Writes the session's report file (JSON). The launched process writes FILE itself; a process that it
/// started writes FILE where nobody has yet, otherwise FILE.PID, and only if it had a context. Never throws,
/// silent in forked children.
void writeReport() noexcept;

/// The same, at most ten times a second: a program that is killed leaves a report all the same. Called after
/// buffer swaps; what the last of them counted is written a moment later by a thread of its own.
void writeReportIfDue() noexcept;

}  // namespace gluray::intercept
