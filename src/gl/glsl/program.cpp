#include "gl/glsl/program.h"

#include "gl/glsl/built_in_variables.h"
#include "gl/real/debug_silence.h"
#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

#include <algorithm>
#include <vector>

namespace gluray::gl {
namespace {

GLint ask(const RealGl& real, GLuint program, GLenum what) {
  GLint value = 0;
  real.GetProgramiv(program, what, &value);
  return value;
}

/// Whether a query raises no error. It is legal only for programs with a certain stage.
bool answers(const RealGl& real, GLuint program, GLenum what) {
  while (real.GetError() != GL_NO_ERROR) {}
  GLint value = 0;
  real.GetProgramiv(program, what, &value);
  return real.GetError() == GL_NO_ERROR;
}

std::string plainName(std::string name) {
  if (name.ends_with("[0]")) name.resize(name.size() - 3);
  return name;
}

void readBlockPlace(const RealGl& real, GLuint program, GLuint index, ProgramUniform& u) {
  if (!isPresent(real.GetActiveUniformsiv)) return;
  const auto property = [&](GLenum what) {
    GLint value = 0;
    real.GetActiveUniformsiv(program, 1, &index, what, &value);
    return value;
  };
  u.block = property(GL_UNIFORM_BLOCK_INDEX);
  if (u.block < 0) return;
  u.offset = property(GL_UNIFORM_OFFSET);
  u.arrayStride = property(GL_UNIFORM_ARRAY_STRIDE);
  u.matrixStride = property(GL_UNIFORM_MATRIX_STRIDE);
  u.rowMajor = property(GL_UNIFORM_IS_ROW_MAJOR) != 0;
}

void readUniforms(const RealGl& real, Program& p) {
  const GLint count = ask(real, p.name, GL_ACTIVE_UNIFORMS);
  std::vector<char> text(static_cast<size_t>(std::max(ask(real, p.name, GL_ACTIVE_UNIFORM_MAX_LENGTH), 1)) +
                         1);
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    ProgramUniform u;
    GLsizei length = 0;
    real.GetActiveUniform(p.name, i, static_cast<GLsizei>(text.size()), &length, &u.count, &u.type,
                          text.data());
    const std::string full(text.data(), static_cast<size_t>(std::max(length, 0)));
    if (isBuiltIn(full)) {
      p.builtInUniforms[plainName(full)] = u.type;
      continue;
    }
    u.location = real.GetUniformLocation(p.name, full.c_str());
    if (u.location < 0) readBlockPlace(real, p.name, i, u);
    const std::string name = plainName(full);
    for (GLint e = 1; u.block < 0 && e < u.count; ++e)
      u.more.push_back(real.GetUniformLocation(p.name, (name + "[" + std::to_string(e) + "]").c_str()));
    p.blocks = p.blocks || u.block >= 0;
    p.uniforms[name] = std::move(u);
  }
  numberElements(p);
}

void readAttributes(const RealGl& real, Program& p) {
  const GLint count = ask(real, p.name, GL_ACTIVE_ATTRIBUTES);
  std::vector<char> text(static_cast<size_t>(std::max(ask(real, p.name, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH), 1)) +
                         1);
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    ProgramAttribute a;
    GLsizei length = 0;
    GLint elements = 0;
    real.GetActiveAttrib(p.name, i, static_cast<GLsizei>(text.size()), &length, &elements, &a.type,
                         text.data());
    const std::string full(text.data(), static_cast<size_t>(std::max(length, 0)));
    a.location = real.GetAttribLocation(p.name, full.c_str());
    p.attributes[plainName(full)] = a;
  }
}

/// Whether draws may write memory other than the framebuffer.
bool writesMemory(const RealGl& real, const Program& p) {
  for (const auto& [name, u] : p.uniforms)
    if (u.type >= GL_IMAGE_1D && u.type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY) return true;
  if (isPresent(real.GetActiveAtomicCounterBufferiv) &&
      ask(real, p.name, GL_ACTIVE_ATOMIC_COUNTER_BUFFERS) > 0)
    return true;
  if (!isPresent(real.GetProgramInterfaceiv)) return false;
  GLint blocks = 0;
  real.GetProgramInterfaceiv(p.name, GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
  return blocks > 0;
}

}  // namespace

void numberElements(Program& program) {
  program.uniformElements = 0;
  for (auto& [name, u] : program.uniforms) {
    u.first = program.uniformElements;
    program.uniformElements += static_cast<size_t>(u.count);
  }
}

Program reflect(const RealGl& real, GLuint name) {
  const int version = versionOf(real);
  const DebugSilence silence(real, version >= 43 || hasExtension(real, version, "GL_KHR_debug"));
  Program p;
  p.name = name;
  p.linked = ask(real, name, GL_LINK_STATUS) == GL_TRUE;
  if (!p.linked) return p;
  p.geometryShader = answers(real, name, GL_GEOMETRY_VERTICES_OUT);
  p.tessellation = isPresent(real.PatchParameteri) && answers(real, name, GL_TESS_GEN_MODE);
  readUniforms(real, p);
  readAttributes(real, p);
  p.writes = writesMemory(real, p);
  while (real.GetError() != GL_NO_ERROR) {}
  return p;
}

bool hasOutput(const RealGl& real, const Program& program, const std::string& name) {
  return isPresent(real.GetFragDataLocation) && real.GetFragDataLocation(program.name, name.c_str()) >= 0;
}

}  // namespace gluray::gl
