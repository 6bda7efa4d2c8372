#include "gl/programs/set_uniform.h"

#include <GL/glext.h>

namespace gluray::gl {
namespace {

void setFloats(const RealGl& real, const UniformValue& v) {
  const GLfloat* f = v.floats.data();
  switch (v.type) {
    case GL_FLOAT: return real.Uniform1fv(v.location, 1, f);
    case GL_FLOAT_VEC2: return real.Uniform2fv(v.location, 1, f);
    case GL_FLOAT_VEC3: return real.Uniform3fv(v.location, 1, f);
    case GL_FLOAT_VEC4: return real.Uniform4fv(v.location, 1, f);
    case GL_FLOAT_MAT2: return real.UniformMatrix2fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT3: return real.UniformMatrix3fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT4: return real.UniformMatrix4fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT2x3: return real.UniformMatrix2x3fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT2x4: return real.UniformMatrix2x4fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT3x2: return real.UniformMatrix3x2fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT3x4: return real.UniformMatrix3x4fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT4x2: return real.UniformMatrix4x2fv(v.location, 1, GL_FALSE, f);
    case GL_FLOAT_MAT4x3: return real.UniformMatrix4x3fv(v.location, 1, GL_FALSE, f);
    default: return;
  }
}

}  // namespace

bool isSettable(GLenum type) {
  const bool isDouble = type == GL_DOUBLE || (type >= GL_DOUBLE_VEC2 && type <= GL_DOUBLE_VEC4) ||
                        (type >= GL_DOUBLE_MAT2 && type <= GL_DOUBLE_MAT4x3);
  const bool isLong = type == GL_INT64_ARB || type == GL_UNSIGNED_INT64_ARB ||
                      (type >= GL_INT64_VEC2_ARB && type <= GL_INT64_VEC4_ARB) ||
                      (type >= GL_UNSIGNED_INT64_VEC2_ARB && type <= GL_UNSIGNED_INT64_VEC4_ARB);
  return !isDouble && !isLong;
}

void setUniform(const RealGl& real, const UniformValue& v) {
  if (v.location < 0) return;
  const UniformShape shape = shapeOf(v.type);
  if (!shape.integers) return setFloats(real, v);
  const bool isUnsigned = v.type == GL_UNSIGNED_INT || v.type == GL_UNSIGNED_INT_VEC2 ||
                          v.type == GL_UNSIGNED_INT_VEC3 || v.type == GL_UNSIGNED_INT_VEC4;
  const GLint* i = v.integers.data();
  if (isUnsigned) {
    const auto* u = reinterpret_cast<const GLuint*>(i);
    if (shape.rows == 1) return real.Uniform1uiv(v.location, 1, u);
    if (shape.rows == 2) return real.Uniform2uiv(v.location, 1, u);
    if (shape.rows == 3) return real.Uniform3uiv(v.location, 1, u);
    return real.Uniform4uiv(v.location, 1, u);
  }
  if (shape.rows == 1) return real.Uniform1iv(v.location, 1, i);
  if (shape.rows == 2) return real.Uniform2iv(v.location, 1, i);
  if (shape.rows == 3) return real.Uniform3iv(v.location, 1, i);
  real.Uniform4iv(v.location, 1, i);
}

}  // namespace gluray::gl
