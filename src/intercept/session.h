// The user's settings for this process, read when the engine starts; settings of frames also when files
// change. Any thread.
#pragma once
#include "settings/live/settings_source.h"

#include <string>

namespace gluray::intercept {

/// The session of this process; reads the environment at the first call.
const Session& session();

/// The current settings: initially the session's.
SettingsSource& settingsOfNow();

/// Whether the launcher started this process, or there was no launcher.
bool launchedProcess();

/// The file that this process writes for the user's `path`: `path` itself, or `path`.PID if another process
/// uses it. Repeated calls may return different names.
std::string fileOfThisProcess(std::string path);

}  // namespace gluray::intercept
