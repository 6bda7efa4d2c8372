// The settings of pictures that are made of saved scenes. Any thread.
#pragma once
#include "command_line.h"

#include <string>

namespace gluray::launcher {

/// Those that the command line chooses: with the values of its preset and quality in place of their names.
/// Throws std::runtime_error with one line.
NamedValues wantedSettings(const CommandLine& line);

/// The command that makes the same picture, for a shell: gluray render, or without a scene gluray shot.
std::string commandOf(const PictureOptions& options, const NamedValues& settings);

}  // namespace gluray::launcher
