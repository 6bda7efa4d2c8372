// Test program inside the launcher: makes a context, draws a triangle and prints which OpenGL it got. `gluray
// doctor` runs it in a process of its own, since drivers and X servers may hang or crash.
#pragma once
#include <string>

namespace gluray::launcher {

/// First argument with which the launcher starts itself as the probe.
inline constexpr const char* kProbeWord = "--probe-context";

/// `api`: "glx" or "egl". Prints vendor, renderer and version, one a line. Returns the exit code: 0, or 1
/// after a line on stderr.
int probeContext(const std::string& api);

}  // namespace gluray::launcher
