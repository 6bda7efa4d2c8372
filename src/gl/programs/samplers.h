// Maps types of sampler uniforms to texture targets and their binding queries.
#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::gl {

struct SamplerTarget {
  GLenum target = 0, binding = 0;  // 0: not a sampler
};

constexpr SamplerTarget samplerTarget(GLenum type) {
  switch (type) {
    case GL_SAMPLER_1D:
    case GL_SAMPLER_1D_SHADOW:
    case GL_INT_SAMPLER_1D:
    case GL_UNSIGNED_INT_SAMPLER_1D: return {GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D};
    case GL_SAMPLER_2D:
    case GL_SAMPLER_2D_SHADOW:
    case GL_INT_SAMPLER_2D:
    case GL_UNSIGNED_INT_SAMPLER_2D: return {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D};
    case GL_SAMPLER_3D:
    case GL_INT_SAMPLER_3D:
    case GL_UNSIGNED_INT_SAMPLER_3D: return {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D};
    case GL_SAMPLER_CUBE:
    case GL_SAMPLER_CUBE_SHADOW:
    case GL_INT_SAMPLER_CUBE:
    case GL_UNSIGNED_INT_SAMPLER_CUBE: return {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP};
    case GL_SAMPLER_2D_RECT:
    case GL_SAMPLER_2D_RECT_SHADOW:
    case GL_INT_SAMPLER_2D_RECT:
    case GL_UNSIGNED_INT_SAMPLER_2D_RECT: return {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE};
    case GL_SAMPLER_1D_ARRAY:
    case GL_SAMPLER_1D_ARRAY_SHADOW:
    case GL_INT_SAMPLER_1D_ARRAY:
    case GL_UNSIGNED_INT_SAMPLER_1D_ARRAY: return {GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY};
    case GL_SAMPLER_2D_ARRAY:
    case GL_SAMPLER_2D_ARRAY_SHADOW:
    case GL_INT_SAMPLER_2D_ARRAY:
    case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY: return {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY};
    case GL_SAMPLER_BUFFER:
    case GL_INT_SAMPLER_BUFFER:
    case GL_UNSIGNED_INT_SAMPLER_BUFFER: return {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER};
    case GL_SAMPLER_2D_MULTISAMPLE:
    case GL_INT_SAMPLER_2D_MULTISAMPLE:
    case GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE:
      return {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE};
    default: return {};
  }
}

}  // namespace gluray::gl
