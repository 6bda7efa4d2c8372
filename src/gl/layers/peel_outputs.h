// Queries the textures that depth peeling passes read and write. Called by LayerDraws, GL thread.
#pragma once
#include "gl/batch/held_pass.h"
#include "gl/program_state/program_state.h"
#include "gl/real/real.h"
#include "gl/shadow/shadow_state.h"

#include <vector>

namespace gluray::gl {

/// The draw framebuffer's colour textures, by draw buffer. Empty if any colour goes elsewhere, or if a
/// texture may be a deleted one whose name was reused.
std::vector<HeldPass::Output> outputsOf(ShadowState& shadow);

/// The texture that receives the output Family::passOutput; 0 if there is none, or if it is not level 0 of a
/// texture.
GLuint outputOf(const RealGl& real, const KnownProgram& known, const std::vector<HeldPass::Output>& outputs);

/// Texture unit of the sampler Family::passInput; -1: none.
GLint inputUnit(const ProgramState& program);

/// The texture bound to GL_TEXTURE_2D of that unit; 0 if there is no texture or no unit.
GLuint inputTexture(const RealGl& real, const ProgramState& program);

/// Whether draws now fill a framebuffer object of the viewport's size and keep the maximum (GL_MAX).
bool peelsIntoAll(ShadowState& shadow);

}  // namespace gluray::gl
