// The options and help texts of the commands about saved scenes.
#pragma once
#include "command_line.h"

namespace CLI {
class App;
}

namespace gluray::launcher {

/// gluray render.
void describeRender(CLI::App& app, CommandLine& line);
/// gluray view.
void describeView(CLI::App& app, CommandLine& line);
/// gluray export.
void describeExport(CLI::App& app, CommandLine& line);

}  // namespace gluray::launcher
