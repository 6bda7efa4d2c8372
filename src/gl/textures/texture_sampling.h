// Reads back the sampling parameters of textures: filters, wrap modes and level of detail. GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/real/extensions.h"
#include "scene/texture.h"

#include <GL/gl.h>

namespace gluray::gl {

/// The sampler object of the active unit; 0: none.
GLuint samplerOf(const RealGl& real);

/// Reads the sampling parameters of the texture bound to `target` of the active unit, or of the unit's
/// sampler object, which replace them. Returns Reason::traced, or why one of them cannot be traced.
Reason readSampling(const RealGl& real, const RareState& has, GLenum target, scene::Texture& texture);

/// Whether the texture bound to `target` of the active unit has a swizzle other than the identity.
bool isSwizzled(const RealGl& real, const RareState& has, GLenum target);

}  // namespace gluray::gl
