// A program of our own: makes a context, draws a triangle, and says which OpenGL it met. `gluray doctor` runs
// it as it would run any program, since drivers and X servers may hang or crash.
#pragma once
#include <string>

namespace gluray::launcher {

/// The first word of the command line by which the launcher starts itself for this.
inline constexpr const char* kProbeWord = "--probe-context";

/// `api`: "glx" or "egl". Prints vendor, renderer and version, one a line. Returns the exit code: 0, or 1
/// after a line on stderr.
int probeContext(const std::string& api);

}  // namespace gluray::launcher
