// Draws a snapshot with the real OpenGL's fixed function: what the program would have had, for when tracing
// fails after its draws were held back. GL thread, compatibility context current, outside glBegin/glEnd.
#pragma once
#include "intercept/present/state_guard.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Draws every instance in order, into the framebuffer that is bound, with depth test `depthFunc`. No
/// queryable state differs afterwards. False, with nothing drawn, where the attribute stack is full or fixed
/// function is missing.
bool drawWithFixedFunction(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                           GLenum depthFunc);

}  // namespace gluray::present
