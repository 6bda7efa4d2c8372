// Copies values of uniforms to the current shader program. GL thread, context current.
#pragma once
#include "gl/programs/uniforms.h"
#include "gl/real/real.h"

#include <GL/gl.h>

namespace gluray::gl {

/// Whether setUniform() supports uniforms of this type: not doubles and not 64-bit handles.
bool isSettable(GLenum type);
/// Sets one element. Does nothing if its location is -1.
void setUniform(const RealGl& real, const UniformValue& value);

}  // namespace gluray::gl
