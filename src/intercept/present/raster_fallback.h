// Draws a snapshot with the real OpenGL: what the program would have had, for when tracing fails after its
// draws were held back. GL thread, outside glBegin/glEnd.
#pragma once
#include "gl/presenter.h"
#include "intercept/present/state_guard.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Draws every instance, into the framebuffer that is bound, with the target's depth function: those of fixed
/// function in order, then those of shader programs in order. No queryable state differs afterwards. False,
/// with nothing drawn, where the attribute stack is full or fixed function is missing and needed.
bool drawByRealGl(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                  const gl::PresentTarget& target);

/// Gives what is seen of the fixed-function instances, which were traced before, the depth that the real
/// OpenGL has for them: so that passes which compare with it find it. Nothing else differs afterwards. False
/// where that is not possible (multisampled framebuffers, no depth textures), with the depth as it was.
bool drawDepthAgain(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot);

}  // namespace gluray::present
