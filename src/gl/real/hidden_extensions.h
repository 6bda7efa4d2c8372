// Extensions hidden from programs by the quirk "hide-persistent-mapping". GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>

namespace gluray::gl {

/// Returns `all`, a glGetString(GL_EXTENSIONS), without the hidden extensions. The text lives as long as the
/// process. Null if `all` is null.
const GLubyte* withoutHidden(const GLubyte* all);
/// GL_NUM_EXTENSIONS without the hidden extensions.
GLint visibleExtensions(const RealGl& real);
/// The real OpenGL's index of visible extension `index`; GL_NUM_EXTENSIONS if there are not that many.
GLuint realExtensionIndex(const RealGl& real, GLuint index);

}  // namespace gluray::gl
