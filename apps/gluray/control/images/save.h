// gluray save: what a running program shows, as a scene in a file; pictures of such scenes.
#pragma once
#include "command_line.h"
#include "control/hub_session.h"

#include <string>

namespace gluray::launcher {

/// Saves what the program shows, with the pixels of its window. Throws std::runtime_error with one line; then
/// a file of that name stays as it was.
void saveScene(HubSession& hub, const RunningProgram& program, const std::string& file);

/// gluray save. Returns the exit code.
int saveProgramsScene(const CommandLine& line);

}  // namespace gluray::launcher
