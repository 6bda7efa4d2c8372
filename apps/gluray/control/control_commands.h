// Carries out the commands that talk to running programs.
#pragma once

namespace gluray::launcher {

struct CommandLine;

/// Carries the command in `line` out, unless it is not one of these commands. Returns its exit code.
bool performControl(const CommandLine& line, int& exitCode);

}  // namespace gluray::launcher
