#include "control/control_commands.h"

#include "command_line.h"
#include "control/images/film.h"
#include "control/images/save.h"
#include "control/images/shot.h"
#include "control/panel.h"
#include "control/programs_list.h"
#include "control/scene/camera.h"
#include "control/scene/light.h"
#include "control/scene/material.h"
#include "control/scene/objects.h"
#include "control/top.h"
#include "control/values/change.h"
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
    case Command::top: exitCode = showTop(line); return true;
    case Command::shot: exitCode = saveShot(line); return true;
    case Command::save: exitCode = saveProgramsScene(line); return true;
    case Command::objects: exitCode = listObjects(line); return true;
    case Command::pick: exitCode = pickObject(line); return true;
    case Command::material: exitCode = changeMaterials(line); return true;
    case Command::light: exitCode = changeLights(line); return true;
    case Command::camera: exitCode = changeCamera(line); return true;
    case Command::film: exitCode = makeFilm(line); return true;
    case Command::panel: exitCode = openPanel(line); return true;
    default: return false;
  }
}

}  // namespace gluray::launcher
