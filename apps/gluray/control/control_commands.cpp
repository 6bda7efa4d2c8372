#include "control/control_commands.h"

#include "command_line.h"
#include "control/change.h"
#include "control/panel.h"
#include "control/programs_list.h"
#include "control/shot.h"
#include "control/watch.h"

namespace gluray::launcher {

bool performControl(const CommandLine& line, int& exitCode) {
  switch (line.command) {
    case Command::list: exitCode = listPrograms(line); return true;
    case Command::set:
    case Command::unset:
    case Command::preset: exitCode = changeSettings(line); return true;
    case Command::undo:
    case Command::redo: exitCode = stepBackOrForth(line); return true;
    case Command::watch: exitCode = watchPrograms(line); return true;
    case Command::shot: exitCode = saveShot(line); return true;
    case Command::panel: exitCode = openPanel(line); return true;
    default: return false;
  }
}

}  // namespace gluray::launcher
