// Detects OpenGL calls that bypass all doors.
#pragma once
#include <string>

namespace gluray::intercept {

/// The driver's library, if the dynamic linker finds its gl* functions first and would bind libraries loaded
/// from now on to them; empty: it finds ours or libglvnd's. Takes the dynamic linker's lock: call it on the
/// program's threads only.
std::string walkedPast();

}  // namespace gluray::intercept
