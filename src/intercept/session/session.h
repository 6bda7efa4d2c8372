// The user's settings for this process, read when the engine starts. Settings that apply to frames are read
// again when files change. Any thread.
#pragma once
#include "settings/live/settings_source.h"

#include <string>

namespace gluray {
class LiveSettings;
}

namespace gluray::intercept {

/// The session of this process. The first call reads the environment.
const Session& session();

/// The current settings: initially the session's.
SettingsSource& settingsOfNow();

/// The object that changes these settings while the process runs. Never destroyed.
LiveSettings& liveSettings();

/// Sets a function that is called with nowSeconds() when frames begin, before they take their settings.
void whenFramesBegin(void (*look)(double now) noexcept) noexcept;

/// Whether this process may connect to hubs: the user has not forbidden it, and it may log or is a rank of an
/// MPI job that the launcher started.
bool mayBeSeenByHubs();

/// Whether the launcher started this process, or there was no launcher.
bool launchedProcess();

/// The program's name as given to the launcher; in other processes, the name of the executable. At most 200
/// bytes; empty if it is unknown.
std::string programName();

/// The file that this process writes if the user named `path`: `path` itself, or `path`.PID if another
/// process uses that. Repeated calls may return different names.
std::string fileOfThisProcess(std::string path);

}  // namespace gluray::intercept
