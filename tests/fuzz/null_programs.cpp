// Shader programs of NullGl: parses their variables from the text, word by word.
#include "tests/fuzz/null_gl_state.h"

#include <algorithm>
#include <cstring>
#include <sstream>

namespace gluray::fuzz {
namespace {

NullProgram& program(GLuint name) { return now().objects->programs[name]; }

GLenum typeNamed(const std::string& word) {
  static const std::map<std::string, GLenum> kTypes = {{"float", GL_FLOAT},
                                                       {"vec2", GL_FLOAT_VEC2},
                                                       {"vec3", GL_FLOAT_VEC3},
                                                       {"vec4", GL_FLOAT_VEC4},
                                                       {"mat3", GL_FLOAT_MAT3},
                                                       {"mat4", GL_FLOAT_MAT4},
                                                       {"int", GL_INT},
                                                       {"bool", GL_BOOL},
                                                       {"sampler2D", GL_SAMPLER_2D},
                                                       {"ivec4", GL_INT_VEC4},
                                                       {"samplerBuffer", GL_SAMPLER_BUFFER}};
  const auto it = kTypes.find(word);
  return it == kTypes.end() ? GLenum{0} : it->second;
}

/// Adds the variables that "uniform TYPE NAME;" or "in TYPE NAME[N];" in a text declare.
void declare(const std::string& text, const std::string& keyword, std::vector<NullProgram::Variable>& out) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, type, name;
    if (!(words >> first >> type >> name) || first != keyword || typeNamed(type) == 0) continue;
    name = name.substr(0, name.find(';'));
    NullProgram::Variable variable{name.substr(0, name.find('[')), typeNamed(type), 1, 0};
    if (const size_t bracket = name.find('['); bracket != name.npos)
      variable.count = std::max(1, std::atoi(name.c_str() + bracket + 1)), variable.name += "[0]";
    const bool known =
        std::any_of(out.begin(), out.end(), [&](const auto& v) { return v.name == variable.name; });
    if (!known) out.push_back(std::move(variable));
  }
}

void APIENTRY linkProgram(GLuint name) {
  NullProgram& p = program(name);
  p.uniforms.clear(), p.attributes.clear(), p.values.clear();
  for (size_t i = 0; i < p.shaders.size(); ++i) {
    const std::string& text = now().objects->shaders[p.shaders[i]];
    declare(text, "uniform", p.uniforms);
    if (text.find("gl_Position") != text.npos) declare(text, "in", p.attributes);
  }
  GLint location = 0;
  for (auto& u : p.uniforms) u.location = std::exchange(location, location + u.count);
  location = 0;
  for (auto& a : p.attributes) a.location = location++;
  p.linked = !p.attributes.empty();
}

void APIENTRY getProgramiv(GLuint name, GLenum what, GLint* out) {
  const NullProgram& p = program(name);
  switch (what) {
    case GL_LINK_STATUS: *out = p.linked; break;
    case GL_DELETE_STATUS: *out = p.deleted; break;
    case GL_ACTIVE_UNIFORMS: *out = static_cast<GLint>(p.uniforms.size()); break;
    case GL_ACTIVE_ATTRIBUTES: *out = static_cast<GLint>(p.attributes.size()); break;
    case GL_ATTACHED_SHADERS: *out = static_cast<GLint>(p.shaders.size()); break;
    case GL_ACTIVE_UNIFORM_MAX_LENGTH:
    case GL_ACTIVE_ATTRIBUTE_MAX_LENGTH: *out = 64; break;
    case GL_GEOMETRY_VERTICES_OUT: now().error = GL_INVALID_OPERATION; break;
    default: *out = 0;
  }
}

using Variables = std::vector<NullProgram::Variable> NullProgram::*;

template <Variables Of>
void APIENTRY getActive(GLuint name, GLuint index, GLsizei size, GLsizei* length, GLint* count, GLenum* type,
                        GLchar* text) {
  const auto& all = program(name).*Of;
  if (index >= all.size() || size < 1) return;
  const auto& v = all[index];
  const size_t copied = std::min(v.name.size(), static_cast<size_t>(size) - 1);
  std::memcpy(text, v.name.data(), copied), text[copied] = 0;
  if (length) *length = static_cast<GLsizei>(copied);
  *count = v.count, *type = v.type;
}

template <Variables Of>
GLint APIENTRY locationOf(GLuint name, const GLchar* text) {
  const std::string wanted = text, plain = wanted.substr(0, wanted.find('['));
  const size_t bracket = wanted.find('[');
  const int element = bracket == wanted.npos ? 0 : std::atoi(text + bracket + 1);
  for (const auto& v : program(name).*Of)
    if (v.name.substr(0, v.name.find('[')) == plain && element < v.count) return v.location + element;
  return -1;
}

template <class T>
void APIENTRY getUniform(GLuint name, GLint location, T* out) {
  const auto& values = program(name).values;
  const auto it = values.find(location);
  if (it == values.end()) return void(*out = T{});
  // An integer query of a matrix would return sixteen values, too.
  for (size_t i = 0; i < it->second.size(); ++i) {
    const double v = it->second[i];
    if constexpr (std::is_integral_v<T>)
      out[i] = v > -2e9 && v < 2e9 ? static_cast<T>(v) : T{0};
    else
      out[i] = static_cast<T>(v);
  }
}

/// Components of the variable at a location of the current program; 0: there is none.
size_t sizeAt(GLint location) {
  for (const auto& u : program(now().program).uniforms) {
    if (location < u.location || location >= u.location + u.count) continue;
    switch (u.type) {
      case GL_FLOAT_VEC2: return 2;
      case GL_FLOAT_VEC3: return 3;
      case GL_FLOAT_VEC4:
      case GL_INT_VEC4: return 4;
      case GL_FLOAT_MAT3: return 9;
      case GL_FLOAT_MAT4: return 16;
      default: return 1;
    }
  }
  return 0;
}

template <class T>
void put(GLint location, size_t size, GLsizei count, const T* values) {
  for (GLint i = 0; i < count; ++i)
    if (sizeAt(location + i) == size)
      program(now().program).values[location + i] = std::vector<double>(
          values + size * static_cast<size_t>(i), values + size * static_cast<size_t>(i + 1));
    else
      now().error = GL_INVALID_OPERATION;
}

template <size_t Size>
void APIENTRY uniforms(GLint location, GLsizei count, const GLfloat* values) {
  put(location, Size, count, values);
}
template <size_t Size>
void APIENTRY matrices(GLint location, GLsizei count, GLboolean, const GLfloat* values) {
  put(location, Size, count, values);
}

void APIENTRY shaderSource(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths) {
  std::string& text = now().objects->shaders[shader];
  text.clear();
  for (GLsizei i = 0; i < count; ++i)
    text += lengths && lengths[i] >= 0 ? std::string(texts[i], static_cast<size_t>(lengths[i])) : texts[i];
}

void APIENTRY getShaderSource(GLuint shader, GLsizei size, GLsizei* length, GLchar* out) {
  const std::string& text = now().objects->shaders[shader];
  if (size < 1) return;
  const size_t copied = std::min(text.size(), static_cast<size_t>(size) - 1);
  std::memcpy(out, text.data(), copied), out[copied] = 0;
  if (length) *length = static_cast<GLsizei>(copied);
}

void APIENTRY getShaderiv(GLuint shader, GLenum what, GLint* out) {
  switch (what) {
    case GL_SHADER_SOURCE_LENGTH: *out = static_cast<GLint>(now().objects->shaders[shader].size()) + 1; break;
    case GL_SHADER_TYPE: *out = static_cast<GLint>(now().objects->shaderTypes[shader]); break;
    default: *out = GL_TRUE;
  }
}

void APIENTRY getAttachedShaders(GLuint name, GLsizei most, GLsizei* count, GLuint* out) {
  const auto& shaders = program(name).shaders;
  const size_t n = std::min(shaders.size(), static_cast<size_t>(std::max(most, 0)));
  std::copy_n(shaders.begin(), n, out);
  if (count) *count = static_cast<GLsizei>(n);
}

}  // namespace

void addPrograms(NullFunctions& functions) {
  using F = GLfloat;
  IS(CreateProgram, []() -> GLuint { return program(now().objects->nextName), now().objects->nextName++; });
  IS(CreateShader, [](GLenum type) -> GLuint {
    return now().objects->shaderTypes[now().objects->nextName] = type, now().objects->nextName++;
  });
  IS(ShaderSource, shaderSource);
  IS(GetShaderSource, getShaderSource);
  IS(GetShaderiv, getShaderiv);
  IS(AttachShader, [](GLuint name, GLuint shader) { program(name).shaders.push_back(shader); });
  IS(DetachShader, [](GLuint name, GLuint shader) { std::erase(program(name).shaders, shader); });
  IS(GetAttachedShaders, getAttachedShaders);
  IS(LinkProgram, linkProgram);
  IS(UseProgram, [](GLuint name) {
    if (name != 0 && !program(name).linked) return void(now().error = GL_INVALID_OPERATION);
    const GLuint last = std::exchange(now().program, name);
    if (last != name && last != 0 && program(last).deleted) now().objects->programs.erase(last);
  });
  IS(DeleteProgram, [](GLuint name) {
    if (name == now().program && name != 0)
      program(name).deleted = true;
    else
      now().objects->programs.erase(name);
  });
  IS(GetProgramiv, getProgramiv);
  IS(GetActiveUniform, getActive<&NullProgram::uniforms>);
  IS(GetActiveAttrib, getActive<&NullProgram::attributes>);
  IS(GetUniformLocation, locationOf<&NullProgram::uniforms>);
  IS(GetAttribLocation, locationOf<&NullProgram::attributes>);
  IS(GetFragDataLocation,
     [](GLuint, const GLchar* name) -> GLint { return std::strcmp(name, "fragOutput0") ? -1 : 0; });
  IS(GetUniformfv, getUniform<F>);
  IS(GetUniformiv, getUniform<GLint>);
  IS(Uniform1i, [](GLint at, GLint v) { put(at, 1, 1, &v); });
  IS(Uniform1f, [](GLint at, F v) { put(at, 1, 1, &v); });
  IS(Uniform1fv, uniforms<1>);
  IS(Uniform2fv, uniforms<2>);
  IS(Uniform3fv, uniforms<3>);
  IS(Uniform4fv, uniforms<4>);
  IS(UniformMatrix3fv, matrices<9>);
  IS(UniformMatrix4fv, matrices<16>);
}

}  // namespace gluray::fuzz
