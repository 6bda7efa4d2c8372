// Reads the OpenGL state that window-space impostors (beads, tubes, splats; scene/impostors.h) depend on.
// Called by ProgramDraws, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/shadow/shadow_state.h"

namespace gluray::gl {

/// Sets the size of the shader program's impostors (ShadowState::setImpostorSize) for a draw of its
/// attributes. Returns why they cannot be traced, or Reason::traced.
Reason readPixelImpostors(ShadowState& shadow);

}  // namespace gluray::gl
