// GLSL's built-in uniforms (gl_ModelViewMatrix, gl_LightSource[0].position ...): fixed function's state,
// which shader programs of families with gl_Vertex read. GL thread, context current.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/program.h"
#include "gl/programs/uniforms.h"

#include <string_view>

namespace gluray::gl {

/// Adds the built-in uniforms that the family mentions to the shader program's uniforms, in place of those
/// added before.
void nameBuiltIns(Program& program, const Family& family);
/// Removes those that nameBuiltIns() has added.
void dropBuiltIns(Program& program);

/// Reads the built-in uniform `name` from fixed function's state.
void readBuiltIn(const RealGl& real, std::string_view name, UniformValue& value);

}  // namespace gluray::gl
