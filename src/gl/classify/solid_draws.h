// Lines and points that settings turn into solids: tubes (scene::Shape::capsules) and spheres (balls). GL
// thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/capture/solid_settings.h"
#include "gl/shadow/shadow_state.h"
#include "scene/snapshot.h"

namespace gluray::gl {

/// Whether all lines of sight are parallel.
bool isParallel(const glm::dmat4& clipFromEye);

/// Why lines or points of fixed function cannot become solids in the current state, or Reason::traced.
Reason solidReason(ShadowState& shadow, PrimitiveClass kind);

/// Completes the instance and shading of a fixed-function draw of solids: their size and, unless the program
/// lights them, a light at the viewer that shows their shape.
void makeSolid(ShadowState& shadow, scene::Instance& instance, scene::Shading& shading);

/// The same two for draws of the current shader program. Programs that light lines give them normals: the
/// solid's own normals replace those.
Reason programSolidReason(ShadowState& shadow, PrimitiveClass kind);
void makeProgramSolid(ShadowState& shadow, scene::Instance& instance);

}  // namespace gluray::gl
