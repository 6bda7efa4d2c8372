// Bits per pixel of the draw framebuffer. Core profiles refuse GL_DEPTH_BITS and the like with
// GL_INVALID_ENUM (OpenGL 3.1 and later, appendix E): there the attachments are queried. GL thread.
#pragma once
#include "gl/real/real.h"

#include <glm/glm.hpp>

namespace gluray::gl {

/// Bits of the depth buffer; 0 if there is none. Raises no error. `fixedFunction`: the context has fixed
/// function, so its profile is not core.
GLint depthBits(const RealGl& real, bool fixedFunction);

/// Red bits of the colour buffer that `drawBuffer` names (as glDrawBuffer does); 0 if there is none. Raises
/// no error.
GLint redBits(const RealGl& real, GLenum drawBuffer, bool fixedFunction);

/// Red, green, blue and alpha bits of that buffer, queried from its attachment: requires OpenGL 3.0.
glm::ivec4 colorBits(const RealGl& real, GLenum drawBuffer);

}  // namespace gluray::gl
