// Reads the OpenGL state that impostors computed in the window (beads, tubes, splats; scene/impostors.h)
// depend on. Called by ProgramDraws, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/real/real.h"
#include "scene/mesh.h"

namespace gluray::gl {

struct State;

/// Completes state.program.impostors for a draw of such impostors of `shape`. Returns why they cannot be
/// traced, or Reason::traced. `core`: the context has no fixed function.
Reason readPixelImpostors(const RealGl& real, bool core, scene::Shape shape, State& state);

}  // namespace gluray::gl
