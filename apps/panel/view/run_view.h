// What gluray-panel does for `gluray view`. GUI thread.
#pragma once

namespace gluray::panel {

/// The first word of such a command line: --view ENGINE LAUNCHER SCENE [--preset NAME] [--quality NAME]
/// [--set NAME=VALUE]..., which the launcher writes.
inline constexpr const char* kViewWord = "--view";

/// Shows the scene until the window is closed. Returns the exit code.
int runView(int argc, char** argv);

}  // namespace gluray::panel
