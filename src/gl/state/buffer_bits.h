// How many bits a pixel of the draw framebuffer has. Core profiles refuse GL_DEPTH_BITS and the like with
// GL_INVALID_ENUM (OpenGL 3.1 and later, appendix E): there the attachments are asked. GL thread.
#pragma once
#include "gl/real.h"

namespace gluray::gl {

/// Of the depth buffer; 0 where there is none. Raises no error. `fixedFunction`: the context has it, so is
/// not of a core profile.
GLint depthBits(const RealGl& real, bool fixedFunction);

/// Of the red part of the colour buffer that `drawBuffer` names (as glDrawBuffer does); 0 where there is
/// none. Raises no error.
GLint redBits(const RealGl& real, GLenum drawBuffer, bool fixedFunction);

}  // namespace gluray::gl
