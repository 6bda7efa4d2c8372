// The state of NullGl, and the lookup of its functions by name. Used only by NullGl's own files.
#pragma once
#include "tests/fuzz/null_gl.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::fuzz {

using Values = std::vector<double>;

/// The state that glPushAttrib saves (all of it).
struct Attributes {
  std::map<GLenum, Values> values;  // by glGet name
  std::set<GLenum> enabled;
  std::map<std::pair<GLenum, GLenum>, Values> lights, materials, environments, generators;
};

struct NullArray {
  GLint size = 4, stride = 0, normalized = 0, enabled = 0, divisor = 0;
  GLenum type = GL_FLOAT;
  GLuint buffer = 0;
  const void* pointer = nullptr;
};

/// A program's variables, parsed from its shaders' text: all that are declared count as active.
struct NullProgram {
  struct Variable {
    std::string name;
    GLenum type = GL_FLOAT;
    GLint count = 1, location = 0;
  };
  std::vector<GLuint> shaders;
  bool linked = false, deleted = false;
  std::vector<Variable> uniforms, attributes;
  std::map<GLint, std::vector<double>> values;  // of uniforms, by location
};

struct NullGl::Objects {
  std::map<GLuint, std::vector<std::byte>> buffers;
  struct Level {
    GLint width = 0, height = 0, depth = 0, format = 0;
    GLuint buffer = 0;
  };
  struct Texture {
    std::map<std::pair<GLenum, GLint>, Level> levels;
    std::map<GLenum, Values> parameters;
  };
  std::map<GLuint, Texture> textures;
  std::map<GLuint, NullProgram> programs;
  std::map<GLuint, std::string> shaders;  // their text
  std::map<GLuint, GLenum> shaderTypes;
  GLuint nextName = 1000, nextList = 1;
};

struct NullGl::State : Attributes {
  std::vector<Attributes> saved;
  std::map<GLenum, std::vector<glm::dmat4>> matrices;
  std::map<GLenum, GLuint> bound;                      // buffers
  std::map<std::pair<GLenum, GLenum>, GLuint> images;  // textures by unit and target
  std::map<std::pair<GLenum, GLenum>, NullArray> arrays;
  struct VertexArray {
    std::map<std::pair<GLenum, GLenum>, NullArray> arrays;
    std::array<NullArray, 16> attributes;
    GLuint elements = 0;
  };
  std::map<GLuint, VertexArray> vertexArrays;  // those that are not bound
  GLuint vertexArray = 0;
  std::array<NullArray, 16> attributes;
  GLuint program = 0;
  GLenum error = GL_NO_ERROR;
  Objects* objects = nullptr;
};

/// The state of the current context.
NullGl::State& now();

using NullFunctions = std::unordered_map<std::string, void*>;
/// The function of that name, with its type in RealGl.
#define IS(NAME, ...)                                      \
  do {                                                     \
    decltype(gl::RealGl::NAME) made = __VA_ARGS__;         \
    functions["gl" #NAME] = reinterpret_cast<void*>(made); \
  } while (false)
void addPrograms(NullFunctions& functions);

}  // namespace gluray::fuzz
