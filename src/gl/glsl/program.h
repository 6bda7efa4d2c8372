// A linked shader program as the real OpenGL describes it: names, locations and types of its active
// variables. Read once per link. GL thread, context current.
#pragma once
#include "gl/glsl/shader_texts.h"
#include "gl/real/real.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// An active uniform. Arrays are named without [0].
struct ProgramUniform {
  GLint location = -1;      // -1: in a block
  std::vector<GLint> more;  // locations of the elements after the first
  GLenum type = 0;
  GLint count = 1;   // elements
  size_t first = 0;  // index of its first element among the elements of all uniforms
  GLint block = -1, offset = 0, arrayStride = 0, matrixStride = 0;
  bool rowMajor = false;
};

/// An active vertex attribute.
struct ProgramAttribute {
  GLint location = -1;
  GLenum type = 0;
};

/// Maps a family's names of variables to the names that a shader program uses instead.
using Renames = std::map<std::string, std::string, std::less<>>;

struct Program {
  GLuint name = 0;
  bool linked = false;
  bool geometryShader = false, tessellation = false;
  bool blocks = false;         // some uniforms are in blocks
  bool writes = false;         // may write memory: atomic counters, shader storage, images
  size_t uniformElements = 0;  // sum over all uniforms
  std::map<std::string, ProgramUniform, std::less<>> uniforms;
  std::map<std::string, GLenum, std::less<>> builtInUniforms;  // those of GLSL that OpenGL lists, with types
  std::map<std::string, ProgramAttribute, std::less<>> attributes;
  Renames renamed;                           // of variables, for the program's family
  std::shared_ptr<const ShaderTexts> texts;  // of the shaders at link time; null: not known

  const ProgramUniform* uniform(std::string_view n) const {
    const auto it = uniforms.find(hereFor(n));
    return it == uniforms.end() ? nullptr : &it->second;
  }
  const ProgramAttribute* attribute(std::string_view n) const {
    const auto it = attributes.find(hereFor(n));
    return it == attributes.end() ? nullptr : &it->second;
  }
  bool isActive(std::string_view n) const { return uniform(n) || attribute(n); }

 private:
  std::string_view hereFor(std::string_view n) const {
    const auto it = renamed.find(n);
    return it == renamed.end() ? n : std::string_view(it->second);
  }
};

/// Whether the program takes its vertices from fixed function's attributes.
inline bool readsFixedVertices(const Program& program) { return program.attributes.contains("gl_Vertex"); }

/// Queries program `name` from the real OpenGL. Clears the GL errors that this raises; the caller must have
/// saved pending ones.
Program reflect(const RealGl& real, GLuint name);
/// Sets ProgramUniform::first of all uniforms, and `uniformElements`.
void numberElements(Program& program);

/// Whether the fragment shader has an output `name`.
bool hasOutput(const RealGl& real, const Program& program, const std::string& name);

}  // namespace gluray::gl
