// gluray set, unset, preset, undo and redo: change settings of running programs.
#pragma once
#include "command_line.h"
#include "control/hub_session.h"

#include <vector>

namespace gluray::launcher {

/// set, unset, preset. Prints what counts from which frame on, program by program. Returns the exit code: 1
/// if a program refused, 2 if a name or a value is wrong.
int changeSettings(const CommandLine& line);

/// Gives settings of the chosen programs these values, as `gluray set` does.
int changeValues(const CommandLine& line, const nlohmann::json& values);

/// undo, redo.
int stepBackOrForth(const CommandLine& line);

/// Sends the request to the programs, prints their results as `gluray set` does, and returns the exit code.
int sendChange(const CommandLine& line, HubSession& hub, const std::vector<RunningProgram>& programs,
               nlohmann::json request);

}  // namespace gluray::launcher
