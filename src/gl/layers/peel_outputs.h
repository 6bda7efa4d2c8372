// Queries the textures that passes of depth peeling read and write. Called by LayerDraws, GL thread.
#pragma once
#include "gl/batch/held_pass.h"
#include "gl/program_state/program_state.h"
#include "gl/real/real.h"
#include "gl/shadow/shadow_state.h"

#include <vector>

namespace gluray::gl {

/// The draw framebuffer's colour textures, by draw buffer; empty if any colour goes elsewhere,
/// or if a texture may be a deleted one that had its name before.
std::vector<HeldPass::Output> outputsOf(ShadowState& shadow);

/// The texture to which the output Family::passOutput goes; 0: none, or not its level 0.
GLuint outputOf(const RealGl& real, const KnownProgram& known, const std::vector<HeldPass::Output>& outputs);

/// Texture unit of the sampler Family::passInput; -1: none.
GLint inputUnit(const ProgramState& program);

/// The texture bound to GL_TEXTURE_2D of that unit; 0: none, or no unit.
GLuint inputTexture(const RealGl& real, const ProgramState& program);

}  // namespace gluray::gl
