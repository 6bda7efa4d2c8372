// Whether calls of OpenGL may reach the driver without passing through a door.
#pragma once
#include <string>

namespace gluray::intercept {

/// The driver's library whose gl* functions the dynamic linker finds first, and binds what libraries link
/// that are loaded from now on; empty: it finds ours or libglvnd's. Takes the dynamic linker's lock: on the
/// program's threads only.
std::string walkedPast();

}  // namespace gluray::intercept
