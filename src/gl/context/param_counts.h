// Lengths of parameter arrays that depend on the parameter's name, for generated stubs that copy the arrays
// into display lists.
#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>

namespace gluray::gl {

constexpr size_t lightParams(GLenum name) {
  switch (name) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_POSITION: return 4;
    case GL_SPOT_DIRECTION: return 3;
    default: return 1;
  }
}
constexpr size_t lightModelParams(GLenum name) { return name == GL_LIGHT_MODEL_AMBIENT ? 4 : 1; }
constexpr size_t materialParams(GLenum name) {
  switch (name) {
    case GL_SHININESS: return 1;
    case GL_COLOR_INDEXES: return 3;
    default: return 4;
  }
}
constexpr size_t fogParams(GLenum name) { return name == GL_FOG_COLOR ? 4 : 1; }
constexpr size_t pointParams(GLenum name) { return name == GL_POINT_DISTANCE_ATTENUATION ? 3 : 1; }
/// glTexParameter, glTexEnv and glTexGen.
constexpr size_t textureParams(GLenum name) {
  switch (name) {
    case GL_TEXTURE_BORDER_COLOR:
    case GL_TEXTURE_ENV_COLOR:
    case GL_TEXTURE_SWIZZLE_RGBA:
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE: return 4;
    default: return 1;
  }
}

}  // namespace gluray::gl
