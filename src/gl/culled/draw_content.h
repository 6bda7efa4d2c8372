// Names the content of a draw whose positions come from an array, so that what was computed for it is found
// again. GL thread, context current.
#pragma once
#include "base/hash.h"
#include "gl/arrays/assembly.h"
#include "gl/basics/reasons.h"
#include "gl/real/elements.h"
#include "gl/shadow/shadow_state.h"

#include <GL/gl.h>

namespace gluray::gl {

struct DrawContent {
  ArrayState arrays;  // only positions and indices
  Assembly assembly;
  Hash128 name;
};

/// Reads the content of a draw with `components` components of `positions`, which is one of `arrays`. Returns
/// CullReason::culled, or the reason why it cannot be read. Positions in the program's memory are hashed at
/// each draw, which must not slow down draws that are not worth culling: they are read only with cull.draws =
/// always.
CullReason readContent(ShadowState& shadow, const ArrayState& arrays, const ArraySource& positions,
                       int components, GLenum mode, const Elements& elements, DrawContent& content);

}  // namespace gluray::gl
