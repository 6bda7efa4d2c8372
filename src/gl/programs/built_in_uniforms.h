// GLSL's built-in uniforms (gl_ModelViewMatrix, gl_LightSource[0].position ...). They hold fixed function's
// state; shader programs of families with gl_Vertex read them. GL thread, context current.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/program.h"
#include "gl/programs/uniforms.h"

#include <string_view>

namespace gluray::gl {

/// Adds the built-in uniforms that the family mentions to the shader program's uniforms. They replace those
/// that an earlier call added.
void nameBuiltIns(Program& program, const Family& family);
/// Removes the uniforms that nameBuiltIns() has added.
void dropBuiltIns(Program& program);

/// Reads the built-in uniform `name` from fixed function's state.
void readBuiltIn(const RealGl& real, std::string_view name, UniformValue& value);

}  // namespace gluray::gl
