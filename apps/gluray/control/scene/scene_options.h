// Options of the commands about what programs draw: objects, pick, material, light, camera, film.
#pragma once

namespace CLI {
class App;
}

namespace gluray::launcher {

struct CommandLine;

/// Adds the options and the help text of the command in `line`, unless it is not one of these commands.
void describeSceneCommand(CLI::App& app, CommandLine& line);

}  // namespace gluray::launcher
