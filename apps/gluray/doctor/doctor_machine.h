// The part of `gluray doctor` that looks at the machine and at GLuRay itself.
#pragma once
#include "command_line.h"
#include "doctor/diagnosis.h"

namespace gluray::launcher {

/// What of the install is there, and whether the engine's libraries are. False where nothing more can be
/// tried.
bool examineInstall(Diagnosis& diagnosis);

/// Cores, memory, display.
void examineMachine(Diagnosis& diagnosis);

/// Draws through GLuRay: the real OpenGL, the ray tracer's parts, whether the picture was traced.
void examineDrawing(const CommandLine& line, Diagnosis& diagnosis);

}  // namespace gluray::launcher
