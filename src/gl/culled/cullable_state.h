// Tests whether OpenGL's state permits culling a draw. GL thread, context current.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/shadow/shadow_state.h"

#include <GL/gl.h>

namespace gluray::gl {

/// Returns the reason why the state does not permit culling, or CullReason::culled. Ignores blending and
/// instances.
CullReason cullableState(ShadowState& shadow, GLenum mode);

/// Returns the reason why a draw cannot be skipped although all its fragments fail the depth test or lie
/// outside of the view, or CullReason::culled. Blending and masks do not matter in that case. Sets `isTested`
/// to whether the depth test passes only nearer or equal fragments.
CullReason hideableState(ShadowState& shadow, GLenum mode, bool& isTested);

/// Returns the reason why hidden surfaces affect the image through blending, or CullReason::culled.
/// `opaque`: alpha is 1; otherwise alpha is unknown.
CullReason cullableBlending(ShadowState& shadow, bool opaque);

/// Whether the colours of the framebuffer are normalised bytes, written as they are.
bool hasByteColors(ShadowState& shadow);

}  // namespace gluray::gl
