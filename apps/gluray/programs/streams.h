// The standard streams that a program gets from the launcher.
#pragma once
#include <string>

namespace gluray::launcher {

/// Opens /dev/null in place of standard streams that are closed, so that no file of the launcher gets their
/// numbers. They are closed again in programs that it starts. Call this at the start of main().
void fillClosedStreams();

/// What standard output and standard error are in a program started now, as the doors and the engine read it
/// (base/guarded_write.h).
std::string streamIdentities();

}  // namespace gluray::launcher
