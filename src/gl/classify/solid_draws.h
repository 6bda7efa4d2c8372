// Lines and points that settings turn into solids: tubes (scene::Shape::capsules) and spheres (balls). GL
// thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/capture/solid_settings.h"
#include "gl/shadow/shadow_state.h"
#include "scene/snapshot.h"

namespace gluray::gl {

/// Whether the projection is parallel.
bool isParallel(const glm::dmat4& clipFromEye);

/// The reason why lines or points of fixed function cannot become solids in the current state, or
/// Reason::traced.
Reason solidReason(ShadowState& shadow, PrimitiveClass kind);

/// Sets instance and shading of a fixed-function draw of solids: their size and, if the program does not
/// light them, a light at the viewer that shows their shape.
void makeSolid(ShadowState& shadow, scene::Instance& instance, scene::Shading& shading);

/// Like solidReason(), for draws of the current shader program.
Reason programSolidReason(ShadowState& shadow, PrimitiveClass kind);
/// Like makeSolid(), for draws of the current shader program. Programs that light lines give them normals;
/// the normals of the solid replace these.
void makeProgramSolid(ShadowState& shadow, scene::Instance& instance);

}  // namespace gluray::gl
