// gluray material: what single objects of a running program are made of, and which rays do not meet them.
#pragma once
#include "command_line.h"

namespace gluray::launcher {

/// Changes or prints entries of the setting material.objects. Returns the exit code: 1 if the program refuses
/// or draws no such object, 2 if a word is wrong.
int changeMaterials(const CommandLine& line);

}  // namespace gluray::launcher
