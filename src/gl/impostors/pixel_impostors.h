// Reads the OpenGL state that impostors computed in the window (beads, tubes, splats; scene/impostors.h)
// depend on. Called by ProgramDraws, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/shadow/shadow_state.h"

namespace gluray::gl {

/// Completes the impostors of the shader program in use (ShadowState::setImpostorSize) for a draw of its
/// attributes. Returns why they cannot be traced, or Reason::traced.
Reason readPixelImpostors(ShadowState& shadow);

}  // namespace gluray::gl
