// How a texture is sampled: filters, wraps and level of detail, read back from the real OpenGL. GL thread.
#pragma once
#include "gl/draws/reasons.h"
#include "gl/state/extensions.h"
#include "scene/texture.h"

#include <GL/gl.h>

namespace gluray::gl {

/// Sampling parameters of the texture bound to `target` of the active unit. Anything but Reason::traced: one
/// is not traced.
Reason readSampling(const RealGl& real, const RareState& has, GLenum target, scene::Texture& texture);

}  // namespace gluray::gl
