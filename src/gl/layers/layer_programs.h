// Which layers shader programs draw. GL thread, context current.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/batch/batch.h"
#include "gl/counts/draw_kinds.h"
#include "gl/shadow/shadow_state.h"

namespace gluray::gl {

/// The pass that the shader program's family describes; `none` if there is none.
Family::Pass passOf(const ProgramState& program);
/// The kind of layers that the program draws in this pass; `none` if there is none.
BatchKey::Layers layersOf(const ProgramState& program);
/// Why the current shader program's layers, peeled or summed, cannot be traced, or Reason::traced.
Reason seenThroughReason(ShadowState& shadow, PrimitiveClass kind);

}  // namespace gluray::gl
