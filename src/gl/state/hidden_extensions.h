// Extensions that programs are not told of: the quirk "hide-persistent-mapping". GL thread, context current.
#pragma once
#include "gl/real.h"

#include <GL/gl.h>

namespace gluray::gl {

/// glGetString(GL_EXTENSIONS) without them; lives as long as the process. Null where `all` is.
const GLubyte* withoutHidden(const GLubyte* all);
/// GL_NUM_EXTENSIONS without them.
GLint visibleExtensions(const RealGl& real);
/// The real OpenGL's index of the one that the program knows by `index`; beyond all of them where it is
/// beyond those that are shown.
GLuint realExtensionIndex(const RealGl& real, GLuint index);

}  // namespace gluray::gl
