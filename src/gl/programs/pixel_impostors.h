// Beads and tubes (scene/impostors.h): what of them is OpenGL's state instead of the program's. GL thread.
#pragma once
#include "gl/draws/reasons.h"
#include "gl/real.h"
#include "scene/mesh.h"

namespace gluray::gl {

struct State;

/// Completes state.program.impostors for a draw of impostors of `shape`, which are computed in the window;
/// why they cannot be traced, or Reason::traced. `core`: the context has no fixed function.
Reason readPixelImpostors(const RealGl& real, bool core, scene::Shape shape, State& state);

}  // namespace gluray::gl
