// Alpha of fixed function's surfaces where rays other than the viewer's hit them: with textures, so that
// holes cut by the alpha test are holes for all rays. Any thread.
#pragma once
#include "accel/rays/occlusion.h"
#include "render/local/surface.h"

namespace gluray::render {

/// Alpha of the fragment at a point of a triangle, before the alpha test: `primary` is that of the colour
/// without textures, 0 .. 1. Textures are sampled at their base level. Those whose coordinates are generated,
/// or whose environment is GL_COMBINE, count as opaque.
float fragmentAlpha(const Surface&, const accel::Occluder&, float primary);

}  // namespace gluray::render
