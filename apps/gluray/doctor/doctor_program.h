// The part of `gluray doctor` that checks a program.
#pragma once
#include "command_line.h"
#include "doctor/diagnosis.h"

namespace gluray::launcher {

/// Reports how the program reaches OpenGL, and which door will be used.
void examineProgram(const CommandLine& line, Diagnosis& diagnosis);

}  // namespace gluray::launcher
