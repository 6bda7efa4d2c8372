// Opens the doors for the program about to be started: sets the environment by which OpenGL loads us.
#pragma once
#include "command_line.h"
#include "programs/program.h"
#include "settings/settings.h"

#include <string>

namespace gluray::launcher {

/// The directory of our libraries, found from this executable's own place; empty if they are not there.
std::string libraryDirectory();

/// What `line`, the environment and the configuration file choose together. Puts what `line` says into the
/// environment of this process, as for a program about to be started; complaints are the engine's to make.
Session sessionOf(const CommandLine& line);

/// Sets every variable that the doors and the engine read. Returns a line for the user where something keeps
/// the program from being traced (it then runs without us), otherwise an empty string.
std::string openDoors(const CommandLine& line, const Program& program);

}  // namespace gluray::launcher
