// The report: what was traced, what was not traced and why, and the costs. Written while the program runs, so
// that a program killed by a signal leaves a report of its last frames (docs/adr/0032), and at exit. Any
// thread.
#pragma once
#include <nlohmann/json_fwd.hpp>

namespace gluray::intercept {

/// Writes the session's report file (JSON). The launched process writes FILE. A process that it started
/// writes FILE if that does not exist yet, otherwise FILE.PID, and only if it had a context. Never throws.
/// Does nothing in forked children. The engine registers it to be called at exit.
void writeReport() noexcept;

/// The report as of now, as JSON. Throws std::bad_alloc.
nlohmann::json reportOfNow();

/// Called when a context has been created. Starts a thread that checks ten times a second for statistics that
/// no frame has written: the last frames of an idle program, and the draws of programs that end no frames.
/// Call without holding locks. Does nothing if no report is requested.
void watchForReport() noexcept;

/// Called when a frame has ended. Writes the report, at most ten times a second except for the first frames.
void writeReportIfDue() noexcept;

}  // namespace gluray::intercept
