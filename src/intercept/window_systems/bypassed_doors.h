// Detects OpenGL calls that bypass all doors.
#pragma once
#include <string>

namespace gluray::intercept {

/// The driver's library, if the dynamic linker finds its gl* functions first, so that it would bind libraries
/// that are loaded later to them. Empty if it finds ours or libglvnd's. Takes the dynamic linker's lock: call
/// only on the program's threads.
std::string walkedPast();

}  // namespace gluray::intercept
