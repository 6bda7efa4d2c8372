// Clears of whole framebuffers. GL thread.
#pragma once
#include "gl/batch/presenter.h"
#include "gl/real.h"
#include "gl/state/extensions.h"
#include "scene/snapshot.h"

namespace gluray::gl {

/// Whether a glClear of colour and depth now writes all of both, within the scissor box, and depth 1.
bool clearsAll(const RealGl& real, const RareState& has);

/// The same of any buffers and values.
bool clearsInFull(const RealGl& real, const RareState& has, GLbitfield mask);

/// Whether glClear(mask) now clears all of the window, however large, in the buffers of `mask`.
bool clearsWindow(const RealGl& real, const RareState& has, GLbitfield mask);

/// glClear(mask) with the values of now.
WindowClear windowClear(const RealGl& real, GLbitfield mask);

/// Whether all of `inner` lies in `outer`.
bool contains(const scene::Region& outer, const scene::Region& inner);

/// Window depth beyond which a hit does not pass the test, GL_LESS or GL_LEQUAL, against depth 1 as a buffer
/// of that resolution has them.
float farthestHit(GLenum depthFunc, float resolution);

}  // namespace gluray::gl
