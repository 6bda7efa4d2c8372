#include "gl/programs/uniforms.h"

#include "gl/families/components.h"
#include "gl/glsl/built_in_variables.h"
#include "gl/programs/built_in_uniforms.h"
#include "gl/programs/uniform_blocks.h"
#include "gl/real/state_queries.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <sstream>

namespace gluray::gl {

UniformShape shapeOf(GLenum type) {
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
    default: return {1, 1, true};
  }
}

namespace {

void readPlain(const RealGl& real, const Program& program, UniformValue& value) {
  if (shapeOf(value.type).integers)
    real.GetUniformiv(program.name, value.location, value.integers.data());
  else
    real.GetUniformfv(program.name, value.location, value.floats.data());
}

/// Reads the element from the buffer behind its uniform block; it stays 0 if there is none.
void readFromBlock(const RealGl& real, const Program& program, const ProgramUniform& u, int element,
                   UniformValue& value) {
  GLint binding = 0;
  real.GetActiveUniformBlockiv(program.name, static_cast<GLuint>(u.block), GL_UNIFORM_BLOCK_BINDING,
                               &binding);
  const BlockBinding bound = boundBlock(real, static_cast<GLuint>(binding));
  if (bound.buffer == 0) return;
  const GLint saved = integer(real, GL_COPY_READ_BUFFER_BINDING);
  real.BindBuffer(GL_COPY_READ_BUFFER, bound.buffer);
  const UniformShape shape = shapeOf(u.type);
  // A matrix in row-major order is stored row by row.
  const bool transposed = u.rowMajor && shape.columns > 1;
  const int lines = transposed ? shape.rows : shape.columns, each = transposed ? shape.columns : shape.rows;
  for (int line = 0; line < lines; ++line) {
    GLint words[4] = {};
    const GLintptr at =
        static_cast<GLintptr>(bound.start) + u.offset + element * u.arrayStride + line * u.matrixStride;
    real.GetBufferSubData(GL_COPY_READ_BUFFER, at, each * 4, words);
    for (int k = 0; k < each; ++k) {
      const auto to = static_cast<size_t>(transposed ? k * shape.rows + line : line * shape.rows + k);
      value.integers[to] = words[k];
      std::memcpy(&value.floats[to], &words[k], 4);
    }
  }
  real.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(saved));
}

}  // namespace

UniformValue readUniform(const RealGl& real, const Program& program, std::string_view name,
                         const ProgramUniform& uniform, int element) {
  UniformValue value;
  value.type = uniform.type;
  if (uniform.block >= 0) {
    readFromBlock(real, program, uniform, element, value);
    return value;
  }
  value.location = element == 0 ? uniform.location : uniform.more[static_cast<size_t>(element - 1)];
  if (value.location >= 0)
    readPlain(real, program, value);
  else if (isBuiltIn(name))
    readBuiltIn(real, name, value);
  return value;
}

UniformValuesPtr readUniforms(const RealGl& real, const Program& program) {
  auto values = std::make_shared<UniformValues>();
  values->reserve(program.uniformElements);
  for (const auto& [name, uniform] : program.uniforms)
    for (int i = 0; i < uniform.count; ++i) values->push_back(readUniform(real, program, name, uniform, i));
  return values;
}

UniformReader::Found UniformReader::find(const std::string& name, int element) const {
  if (const UniformValue* whole = findWhole(name, element)) return {whole};
  const int component = componentIn(name);
  if (component < 0) return {};
  const UniformValue* whole = findWhole(std::string_view(name).substr(0, name.size() - 2), element);
  const UniformShape shape = whole ? shapeOf(whole->type) : UniformShape{};
  const bool column = shape.columns > 1 && name.back() <= '3';  // columns have numbers alone
  const int count = shape.columns == 1 ? shape.rows : column ? shape.columns : 0;
  return component < count ? Found{whole, component} : Found{};
}

const UniformValue* UniformReader::findWhole(std::string_view name, int element) const {
  const ProgramUniform* u = name.empty() ? nullptr : program_.uniform(name);
  if (const size_t bracket = name.rfind('[');
      !u && bracket != std::string_view::npos && name.ends_with(']')) {
    const char *number = name.data() + bracket + 1, *end = name.data() + name.size() - 1;
    const auto [stop, error] = std::from_chars(number, end, element);
    if (error == std::errc() && stop == end) u = program_.uniform(name.substr(0, bracket));
  }
  if (!u || element < 0 || element >= u->count) return nullptr;
  return &values_[u->first + static_cast<size_t>(element)];
}

glm::vec4 UniformReader::vector(const std::string& name, int element) const {
  const auto [v, component] = find(name, element);
  if (!v) return glm::vec4(0);
  if (const UniformShape shape = shapeOf(v->type); shape.columns > 1 && component >= 0) {
    glm::vec4 column(0);
    for (int r = 0; r < shape.rows; ++r)
      column[r] = v->floats[static_cast<size_t>(component * shape.rows + r)];
    return column;
  }
  const glm::vec4 all = shapeOf(v->type).integers
                            ? glm::vec4(v->integers[0], v->integers[1], v->integers[2], v->integers[3])
                            : glm::vec4(v->floats[0], v->floats[1], v->floats[2], v->floats[3]);
  return component < 0 ? all : glm::vec4(all[component], 0, 0, 0);
}

int UniformReader::integer(const std::string& name) const {
  const UniformValue* v = findWhole(name, 0);
  if (!v) return 0;
  return shapeOf(v->type).integers ? v->integers[0] : static_cast<int>(v->floats[0]);
}

glm::mat4 UniformReader::matrix4(const std::string& name) const {
  glm::mat4 m(1);
  const UniformValue* v = findWhole(name, 0);
  const UniformShape shape = v ? shapeOf(v->type) : UniformShape{};
  if (shape.columns < 2) return m;
  for (int c = 0; c < shape.columns; ++c)
    for (int r = 0; r < shape.rows; ++r) m[c][r] = v->floats[static_cast<size_t>(c * shape.rows + r)];
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

std::string inWords(const std::vector<float>& numbers) {
  std::ostringstream text;
  for (size_t i = 0; i < numbers.size(); ++i)
    text << (i ? ", " : numbers.size() > 1 ? "(" : "") << numbers[i];
  if (numbers.size() > 1) text << ")";
  return text.str();
}

std::string UniformReader::unlike(const std::string& name, const std::vector<float>& neutral) const {
  const ProgramUniform* u = name.empty() ? nullptr : program_.uniform(name);
  for (int element = 0; u && element < u->count; ++element) {
    const UniformValue& v = *findWhole(name, element);
    const UniformShape shape = shapeOf(v.type);
    std::vector<float> now;
    bool same = neutral.size() <= 1 || neutral.size() == static_cast<size_t>(shape.columns * shape.rows);
    for (int i = 0; i < shape.columns * shape.rows; ++i) {
      const auto at = static_cast<size_t>(i);
      now.push_back(shape.integers ? static_cast<float>(v.integers[at]) : v.floats[at]);
      const float identity = i / shape.rows == i % shape.rows ? 1.0f : 0.0f;
      const float wanted =
          neutral.empty() ? identity : neutral[neutral.size() == 1 ? 0 : at % neutral.size()];
      same = same && now.back() == wanted;
    }
    if (!same) return inWords(now);
  }
  return "";
}

glm::vec4 UniformReader::value(const FamilyValue& value, const glm::vec4& otherwise) const {
  glm::vec4 product = first(value, otherwise);
  for (const std::string& factor : value.factors) product *= first({factor, {}}, glm::vec4(1));
  return product;
}

glm::vec4 UniformReader::first(const FamilyValue& value, const glm::vec4& otherwise) const {
  if (!value.constant.empty()) {
    glm::vec4 v(value.constant[0]);
    for (size_t i = 1; i < value.constant.size(); ++i) v[static_cast<int>(i)] = value.constant[i];
    return v;
  }
  if (const auto it = placeholders_.find(value.uniform); it != placeholders_.end())
    return glm::vec4(it->second);
  const Found found = find(value.uniform, 0);
  if (!found.value) return otherwise;
  const glm::vec4 v = vector(value.uniform);
  const UniformShape shape = shapeOf(found.value->type);
  if (shape.rows == 1 || (found.component >= 0 && shape.columns == 1)) return glm::vec4(v.x);
  return shape.rows == 3 ? glm::vec4(glm::vec3(v), 1) : v;
}

}  // namespace gluray::gl
