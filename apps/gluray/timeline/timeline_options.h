// The options and the help text of gluray timeline.
#pragma once
#include "command_line.h"

namespace CLI {
class App;
}

namespace gluray::launcher {

void describeTimeline(CLI::App& app, CommandLine& line);

}  // namespace gluray::launcher
