// Where passes of depth peeling read and write, asked of the real OpenGL. GL thread.
#pragma once
#include "gl/programs/held_pass.h"
#include "gl/programs/program_state.h"
#include "gl/real.h"

#include <vector>

namespace gluray::gl {

/// Where the draw framebuffer's colours go; empty where that is not to textures alone.
std::vector<HeldPass::Output> outputsOf(const RealGl& real);

/// The texture that the program's output goes to; 0: none, or not its level 0.
GLuint outputOf(const RealGl& real, const KnownProgram& known, const std::vector<HeldPass::Output>& outputs);

/// Unit that the family's input is looked up on; -1: none.
GLint inputUnit(const ProgramState& program);

/// The texture that is bound there; 0: none, or no unit.
GLuint inputTexture(const RealGl& real, const ProgramState& program);

}  // namespace gluray::gl
