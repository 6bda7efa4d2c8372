// The user's settings for this process, read when the engine starts; settings of frames also when files
// change. Any thread.
#pragma once
#include "settings/live/settings_source.h"

#include <string>

namespace gluray {
class LiveSettings;
}

namespace gluray::intercept {

/// The session of this process; reads the environment at the first call.
const Session& session();

/// The current settings: initially the session's.
SettingsSource& settingsOfNow();

/// What changes them while the process runs. Lives forever.
LiveSettings& liveSettings();

/// `look` is called when frames begin, before they take their settings, with nowSeconds().
void whenFramesBegin(void (*look)(double now) noexcept) noexcept;

/// Whether hubs may see this process: the user has not forbidden it, and it may log or is a rank of an MPI
/// job that the launcher started.
bool mayBeSeenByHubs();

/// Whether the launcher started this process, or there was no launcher.
bool launchedProcess();

/// The file that this process writes for the user's `path`: `path` itself, or `path`.PID if another process
/// uses it. Repeated calls may return different names.
std::string fileOfThisProcess(std::string path);

}  // namespace gluray::intercept
