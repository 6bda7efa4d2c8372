// Draws by shader programs, made again by the real OpenGL from what was kept of them. GL thread.
#pragma once
#include "gl/programs/program_draw.h"
#include "intercept/present/write_back/state_guard.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::present {

/// Draws them in order into the snapshot's region with the batch's depth state, and leaves all state, the
/// programs' uniforms included, as it was.
void replayProgramDraws(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                        GLenum depthFunc, const std::vector<gl::ProgramDraw>& draws);
/// The same into the draw framebuffer as it is, with the fragment state that is set.
void replayProgramDraws(const gl::RealGl& real, const Features& features,
                        const std::vector<gl::ProgramDraw>& draws);

}  // namespace gluray::present
