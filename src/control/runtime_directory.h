// The user's runtime directory, in which the hub listens (docs/control-protocol.md). Any thread.
#pragma once
#include <string>

namespace gluray::control {

/// $GLURAY_RUNTIME, or gluray in $XDG_RUNTIME_DIR, or /tmp/gluray-UID.
std::string runtimeDirectory();

/// Why nobody may use the directory: it must be a directory, not a link to one, of this user, with mode 0700.
/// Empty: it may be used.
std::string whyUnsafe(const std::string& directory);

/// Creates the directory if there is none. Returns why it may not be used; empty: it may.
std::string makeRuntimeDirectory(const std::string& directory);

}  // namespace gluray::control
