// Queries the state of the real OpenGL that decides what a glClear covers. GL thread.
#pragma once
#include "gl/batch/presenter.h"
#include "gl/real/extensions.h"
#include "gl/real/real.h"
#include "scene/snapshot.h"

namespace gluray::gl {

/// Whether a glClear of colour and depth would now write all of both in the scissor box, with depth 1.
bool clearsAll(const RealGl& real, const RareState& has);

/// Whether a glClear of the buffers in `mask` would now write all of them in the scissor box, with any clear
/// values.
bool clearsInFull(const RealGl& real, const RareState& has, GLbitfield mask);

/// Whether glClear(mask) would now clear the buffers in `mask` in the whole window, whatever its size, and
/// store the clear colour unchanged.
bool clearsWindow(const RealGl& real, const RareState& has, GLbitfield mask);

/// The effect of glClear(mask) with the current clear values.
WindowClear windowClear(const RealGl& real, GLbitfield mask);

/// Whether all of `inner` lies in `outer`.
bool contains(const scene::Region& outer, const scene::Region& inner);

/// The largest window depth of a hit that passes GL_LESS or GL_LEQUAL against depth 1, in a buffer of that
/// depth resolution.
float farthestHit(GLenum depthFunc, float resolution);

}  // namespace gluray::gl
