// The part of `gluray doctor` that checks the machine and GLuRay's install.
#pragma once
#include "command_line.h"
#include "doctor/diagnosis.h"

namespace gluray::launcher {

/// Checks GLuRay's files and the engine's libraries. False: so broken that drawing cannot be tried.
bool examineInstall(Diagnosis& diagnosis);

/// Cores, memory, display.
void examineMachine(Diagnosis& diagnosis);

/// Draws a test image through GLuRay; reports the real OpenGL, the ray tracer's libraries, and whether the
/// image was traced.
void examineDrawing(const CommandLine& line, Diagnosis& diagnosis);

}  // namespace gluray::launcher
