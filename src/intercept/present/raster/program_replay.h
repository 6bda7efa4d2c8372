// Replays kept draws of shader programs with the real OpenGL. GL thread.
#pragma once
#include "gl/batch/program_draw.h"
#include "intercept/present/state/state_guard.h"
#include "scene/snapshot.h"

#include <functional>
#include <vector>

namespace gluray::present {

/// Calls `drawIt` with the draw's program in use, its uniforms, textures and state of polygons; then restores
/// all that, but point size, line width and front and cull faces.
void drawWithInputs(const gl::RealGl& real, const Features& features, const gl::ProgramDraw& draw,
                    const std::function<void()>& drawIt);

/// Replays the draws that have arrays in order into the snapshot's region with the batch's depth state.
/// Restores all state, including the programs' uniforms.
void replayProgramDraws(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                        GLenum depthFunc, const std::vector<gl::ProgramDraw>& draws);
/// The same into the current draw framebuffer with the current fragment state.
void replayProgramDraws(const gl::RealGl& real, const Features& features,
                        const std::vector<gl::ProgramDraw>& draws);

}  // namespace gluray::present
