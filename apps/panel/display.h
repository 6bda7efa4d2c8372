// Whether there is a display, before Qt looks for one. Any thread.
#pragma once

namespace gluray::panel {

/// One line on standard error instead of Qt's abort. False: there is no display that Qt could use. `program`:
/// who says so; `others`: what needs no display.
bool displayIsThere(int argc, char** argv, const char* program, const char* others);

}  // namespace gluray::panel
