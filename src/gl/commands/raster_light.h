// Light on draws that the real OpenGL has made (setting light.rasterised, docs/light/rasterised.md). GL
// thread.
#pragma once
#include "gl/real/elements.h"

#include <GL/gl.h>

namespace gluray::gl {

class Context;

/// Call after a rasterised draw. Where its surfaces are known, they join a batch that multiplies the light
/// that they take from each other, and that others take from them, onto the framebuffer. Does nothing while
/// the settings do not ask for it. Never throws.
void lightRasterised(Context& context, GLenum mode, const Elements& elements) noexcept;

}  // namespace gluray::gl
