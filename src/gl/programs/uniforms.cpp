#include "gl/programs/uniforms.h"

#include "gl/state_queries.h"

#include <algorithm>
#include <cstring>

namespace gluray::gl {
namespace {

struct Shape {
  int columns = 1, rows = 1;
  bool integers = false;
};

Shape shapeOf(GLenum type) {
  switch (type) {
    case GL_FLOAT: return {1, 1};
    case GL_FLOAT_VEC2: return {1, 2};
    case GL_FLOAT_VEC3: return {1, 3};
    case GL_FLOAT_VEC4: return {1, 4};
    case GL_FLOAT_MAT2: return {2, 2};
    case GL_FLOAT_MAT3: return {3, 3};
    case GL_FLOAT_MAT4: return {4, 4};
    case GL_FLOAT_MAT2x3: return {2, 3};
    case GL_FLOAT_MAT2x4: return {2, 4};
    case GL_FLOAT_MAT3x2: return {3, 2};
    case GL_FLOAT_MAT3x4: return {3, 4};
    case GL_FLOAT_MAT4x2: return {4, 2};
    case GL_FLOAT_MAT4x3: return {4, 3};
    case GL_INT_VEC2:
    case GL_UNSIGNED_INT_VEC2:
    case GL_BOOL_VEC2: return {1, 2, true};
    case GL_INT_VEC3:
    case GL_UNSIGNED_INT_VEC3:
    case GL_BOOL_VEC3: return {1, 3, true};
    case GL_INT_VEC4:
    case GL_UNSIGNED_INT_VEC4:
    case GL_BOOL_VEC4: return {1, 4, true};
    default: return {1, 1, true};  // single integers, booleans, samplers
  }
}

}  // namespace

bool UniformReader::readBlock(const ProgramUniform& u, int element, float* out, int columns, int rows) const {
  GLint binding = 0, buffer = 0;
  GLint64 start = 0;
  real_.GetActiveUniformBlockiv(program_.name, static_cast<GLuint>(u.block), GL_UNIFORM_BLOCK_BINDING, &binding);
  const auto slot = static_cast<GLuint>(binding);
  real_.GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, slot, &buffer);
  if (buffer == 0) return false;
  real_.GetInteger64i_v(GL_UNIFORM_BUFFER_START, slot, &start);
  const GLint saved = gl::integer(real_, GL_COPY_READ_BUFFER_BINDING);
  real_.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(buffer));
  const bool integers = shapeOf(u.type).integers;
  // A matrix in row-major order is stored row by row.
  const int lines = u.rowMajor && columns > 1 ? rows : columns, each = u.rowMajor && columns > 1 ? columns : rows;
  for (int line = 0; line < lines; ++line) {
    float values[4] = {};
    const GLintptr at = static_cast<GLintptr>(start) + u.offset + element * u.arrayStride + line * u.matrixStride;
    real_.GetBufferSubData(GL_COPY_READ_BUFFER, at, each * 4, values);
    for (int k = 0; k < each; ++k) {
      float v = values[k];
      if (integers) {
        int32_t number;
        std::memcpy(&number, &v, 4);
        v = static_cast<float>(number);
      }
      const bool transposed = u.rowMajor && columns > 1;
      out[transposed ? k * rows + line : line * rows + k] = v;
    }
  }
  real_.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(saved));
  return true;
}

bool UniformReader::read(const std::string& name, int element, float* out, int& columns, int& rows) const {
  const ProgramUniform* u = name.empty() ? nullptr : program_.uniform(name);
  if (!u || element >= u->count) return false;
  const Shape shape = shapeOf(u->type);
  columns = shape.columns, rows = shape.rows;
  if (u->block >= 0) return readBlock(*u, element, out, columns, rows);
  GLint location = u->location;
  if (element > 0)
    location = real_.GetUniformLocation(program_.name, (name + "[" + std::to_string(element) + "]").c_str());
  if (location < 0) return false;
  if (shape.integers) {
    GLint values[4] = {};
    real_.GetUniformiv(program_.name, location, values);
    std::transform(values, values + 4, out, [](GLint v) { return static_cast<float>(v); });
  } else {
    real_.GetUniformfv(program_.name, location, out);
  }
  return true;
}

glm::vec4 UniformReader::vector(const std::string& name, int element) const {
  float v[16] = {};
  int columns = 0, rows = 0;
  read(name, element, v, columns, rows);
  return {v[0], v[1], v[2], v[3]};
}

int UniformReader::integer(const std::string& name) const { return static_cast<int>(number(name)); }

glm::mat4 UniformReader::matrix4(const std::string& name) const {
  float v[16] = {};
  int columns = 0, rows = 0;
  glm::mat4 m(1);
  if (!read(name, 0, v, columns, rows) || columns < 2) return m;
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r) m[c][r] = v[c * rows + r];
  return m;
}

glm::mat3 UniformReader::matrix3(const std::string& name) const { return glm::mat3(matrix4(name)); }

std::optional<glm::dmat4> UniformReader::product(const std::vector<std::string>& names) const {
  if (names.empty()) return std::nullopt;
  glm::dmat4 m(1);
  for (const std::string& name : names) {
    if (!has(name)) return std::nullopt;
    m = m * glm::dmat4(matrix4(name));
  }
  return m;
}

glm::vec4 UniformReader::value(const FamilyValue& value, const glm::vec4& otherwise) const {
  if (!value.constant.empty()) {
    glm::vec4 v(value.constant[0]);
    for (size_t i = 1; i < value.constant.size(); ++i) v[static_cast<int>(i)] = value.constant[i];
    return v;
  }
  const ProgramUniform* u = value.uniform.empty() ? nullptr : program_.uniform(value.uniform);
  if (!u) return otherwise;
  const glm::vec4 v = vector(value.uniform);
  const Shape shape = shapeOf(u->type);
  if (shape.rows == 1) return glm::vec4(v.x);
  return shape.rows == 3 ? glm::vec4(glm::vec3(v), 1) : v;
}

}  // namespace gluray::gl
