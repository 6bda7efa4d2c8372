// gluray export: saved scenes in other programs' forms.
#pragma once
#include "command_line.h"

#include <string>
#include <vector>

namespace gluray::launcher {

/// Writes the scene in the form that the ending of `file` says. Returns a line for each kind of thing that
/// was left out or approximated. Throws std::runtime_error with one line; then a file of that name stays as
/// it was.
std::vector<std::string> exportScene(const std::string& scene, const std::string& file);

/// gluray export. Returns the exit code.
int exportSaved(const CommandLine& line);

}  // namespace gluray::launcher
