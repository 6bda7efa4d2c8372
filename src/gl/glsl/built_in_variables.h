// GLSL's built-in variables that families may name: fixed function's attributes and state (GLSL 1.20, 7.3 and
// 7.5). Any thread.
#pragma once
#include <GL/gl.h>

#include <string_view>

namespace gluray::gl {

inline bool isBuiltIn(std::string_view name) { return name.substr(0, 3) == "gl_"; }

bool isBuiltInAttribute(std::string_view name);

/// The state that a built-in uniform such as gl_LightSource[0].position stands for. A final ".a" of a vec4
/// selects its alpha.
struct BuiltInUniform {
  enum class Of {
    none,
    modelview,
    projection,
    clip,
    normals,
    textureMatrix,  // of unit 0
    fog,
    fogScale,  // 1 / (end - start)
    lightModel,
    sceneColor,
    light,
    product,
    material
  };
  Of of = Of::none;
  GLenum face = GL_FRONT;  // for product, sceneColor and material
  GLuint light = 0;        // the light's number, for light and product
  GLenum what = 0;         // parameter, for light, product, material and fog: GL_AMBIENT, GL_FOG_END ...
  bool alpha = false;
};
/// The state that `name` stands for; Of::none if it is not a known built-in uniform.
BuiltInUniform builtInUniform(std::string_view name);

/// The built-in uniform's GLSL type; 0 if it is not known.
GLenum builtInUniformType(std::string_view name);

}  // namespace gluray::gl
