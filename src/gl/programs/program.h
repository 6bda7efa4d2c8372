// A linked shader program as the real OpenGL describes it: names, places and types of what is active. Read
// once a link. GL thread, context current.
#pragma once
#include "gl/real.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// An active uniform. Arrays go by their name without [0].
struct ProgramUniform {
  GLint location = -1;      // -1: in a block
  std::vector<GLint> more;  // locations of the elements after the first
  GLenum type = 0;
  GLint count = 1;   // elements
  size_t first = 0;  // elements of all uniforms before it
  GLint block = -1, offset = 0, arrayStride = 0, matrixStride = 0;
  bool rowMajor = false;
};

struct ProgramAttribute {
  GLint location = -1;
  GLenum type = 0;
};

/// Names that a family uses, and those that a program has in their place.
using Renames = std::map<std::string, std::string, std::less<>>;

struct Program {
  GLuint name = 0;
  bool linked = false;
  bool geometryShader = false, tessellation = false;
  bool blocks = false;         // some uniforms are in blocks
  bool writes = false;         // or may: atomic counters, shader storage, images
  size_t uniformElements = 0;  // of all uniforms together
  std::map<std::string, ProgramUniform, std::less<>> uniforms;
  std::map<std::string, ProgramAttribute, std::less<>> attributes;
  Renames renamed;  // by its family

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

/// Asks the real OpenGL about program `name`. Errors that asking raises are taken away; the caller has saved
/// the program's own.
Program reflect(const RealGl& real, GLuint name);

/// Whether `name` is the name of an output of the fragment shader.
bool hasOutput(const RealGl& real, const Program& program, const std::string& name);

}  // namespace gluray::gl
