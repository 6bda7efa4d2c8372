// Tests whether OpenGL's state permits culling a draw. GL thread, context current.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/shadow/shadow_state.h"

#include <GL/gl.h>

namespace gluray::gl {

/// Why it may not, or CullReason::culled. Blending and instances are not looked at.
CullReason cullableState(const ShadowState& shadow, GLenum mode);

/// Why a draw cannot be left out as a whole, whose fragments would all lose the depth test or lie outside of
/// the view, or CullReason::culled. Blending and masks do not matter then. `isTested`: set to whether the
/// depth test takes only fragments that are nearer, as near, or both.
CullReason hideableState(const ShadowState& shadow, GLenum mode, bool& isTested);

/// Why blending shows what is hidden at the end where alpha is 1 or, if not `opaque`, whatever it is;
/// CullReason::culled: it does not.
CullReason cullableBlending(const ShadowState& shadow, bool opaque);

/// Whether the colours of the framebuffer are normalised bytes, written as they are.
bool hasByteColors(const ShadowState& shadow);

}  // namespace gluray::gl
