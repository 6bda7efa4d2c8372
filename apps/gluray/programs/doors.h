// Opens the doors for the program about to be started: sets the environment by which it loads GLuRay.
#pragma once
#include "command_line.h"
#include "programs/program.h"
#include "settings/settings.h"

#include <string>

namespace gluray::launcher {

/// The file of this executable: /proc/self/exe, or where there is none the name by which it was started.
std::string launcherFile();

/// The directory of our libraries, found from this executable's own place; empty if they are not there.
std::string libraryDirectory();

/// The settings that result from `line`, the environment and the configuration files. Puts those of `line`
/// into the environment of this process, as for a program about to be started. The engine reports errors.
Session sessionOf(const CommandLine& line);

/// Sets every variable that the doors and the engine read. Returns an empty string, or one line for the user
/// if the program cannot be traced (it then runs without GLuRay).
std::string openDoors(const CommandLine& line, const Program& program);

}  // namespace gluray::launcher
