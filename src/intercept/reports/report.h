// The report: what was traced, what was not and why, and what it cost. Written while the program runs, so
// that one that ends by a signal leaves a report of its last frames (docs/adr/0032), and at exit, for which
// the engine registers it.
#pragma once

namespace gluray::intercept {

/// Writes the session's report file (JSON). The launched process writes FILE itself; a process that it
/// started writes FILE where nobody has yet, otherwise FILE.PID, and only if it had a context. Never throws,
/// silent in forked children.
void writeReport() noexcept;

/// A context has been made. From now on a thread of its own looks ten times a second for what no frame has
/// written: the last frames of a program that has come to rest, and what is drawn by programs that end none.
/// Called outside of all locks. Does nothing where no report is wanted.
void watchForReport() noexcept;

/// A frame has ended. Writes the same, at most ten times a second but for the first frames.
void writeReportIfDue() noexcept;

}  // namespace gluray::intercept
