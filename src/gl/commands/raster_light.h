// Light on draws that the real OpenGL has made (setting light.rasterised, docs/light/rasterised.md). GL
// thread.
#pragma once
#include "gl/real/elements.h"

#include <GL/gl.h>

namespace gluray::gl {

class Context;

/// Call after a rasterised draw. If its surfaces are known, they join a batch that multiplies shadows and
/// occlusion between them and other surfaces onto the framebuffer. Does nothing unless the settings request
/// it. Never throws.
void lightRasterised(Context& context, GLenum mode, const Elements& elements) noexcept;

}  // namespace gluray::gl
