// What the user asked for, read once when the engine starts. Any thread.
#pragma once
#include "settings/settings_source.h"

#include <string>

namespace gluray::intercept {

/// The session of this process; reads the environment at the first call.
const Session& session();

/// The settings of now: at first those of the session.
SettingsSource& settingsOfNow();

/// Whether this is the process that the launcher started, or there was no launcher.
bool launchedProcess();

/// The file that this process writes where the user named `path`: that, or where another process has it
/// `path`.PID. The same question twice may have two answers.
std::string fileOfThisProcess(std::string path);

}  // namespace gluray::intercept
