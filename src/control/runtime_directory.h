// The user's runtime directory, in which the hub listens (docs/control-protocol.md). Any thread.
#pragma once
#include <string>

namespace gluray::control {

/// $GLURAY_RUNTIME, or gluray in $XDG_RUNTIME_DIR, or /tmp/gluray-UID.
std::string runtimeDirectory();

/// Why the directory must not be used; empty if it may. It must be a directory, not a link to one, belong to
/// this user, and have mode 0700.
std::string whyUnsafe(const std::string& directory);

/// Creates the directory if it does not exist. Returns why it must not be used; empty if it may.
std::string makeRuntimeDirectory(const std::string& directory);

}  // namespace gluray::control
