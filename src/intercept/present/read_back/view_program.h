// Shader programs that draw one triangle around the view. GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>

namespace gluray::present {

/// Builds a program with this fragment shader (GLSL 1.50); 0: it does not link.
GLuint buildViewProgram(const gl::RealGl& real, bool compatibility, const char* fragmentShader);
/// Draws with it; it is in use, and outside of the compatibility profile a vertex array is bound.
void drawAroundView(const gl::RealGl& real, bool compatibility);

}  // namespace gluray::present
