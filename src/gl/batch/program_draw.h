// A shader program's draw with all its inputs. It is kept while its instance is in the batch: if tracing
// fails, the real OpenGL replays the draw. GL thread.
#pragma once
#include "gl/buffers/buffer.h"
#include "gl/glsl/program.h"
#include "gl/programs/samplers.h"
#include "gl/programs/uniform_blocks.h"
#include "gl/programs/uniforms.h"
#include "gl/real/elements.h"
#include "scene/snapshot.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace gluray::gl {

struct ArrayState;
struct KnownProgram;

/// Fixed function's attributes and state for a draw of a shader program that reads them (gl_Vertex,
/// gl_LightSource ...).
struct BuiltInInputs {
  scene::Instance instance;    // mesh, matrix, current values and materials of the draw
  scene::Shading state;        // all lights, on or off; the light model's ambient colour; fog
  glm::mat4 textureMatrix{1};  // of texture unit 0
};

struct ProgramDraw {
  struct Array {
    GLuint location = 0;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    bool normalized = false, integer = false;
    GLsizei stride = 0;
    size_t offset = 0;  // bytes into `contents`
    GLuint divisor = 0;
    std::shared_ptr<const BufferStorage> contents;
  };
  struct BoundTexture {
    GLuint unit = 0;
    SamplerTarget target;
    GLuint name = 0;
    GLuint buffer = 0;  // the buffer of a buffer texture; 0: not a buffer texture
  };
  GLuint program = 0;
  GLenum mode = GL_TRIANGLES;
  Elements elements;  // `indices` is an offset into `indexContents`
  std::shared_ptr<const BufferStorage> indexContents;
  std::vector<Array> arrays;
  std::vector<BoundTexture> textures;
  UniformValuesPtr uniforms;
  std::vector<UniformBlock> blocks;
  bool cull = false;
  GLenum cullFace = GL_BACK, frontFace = GL_CCW;
  float pointSize = 1, lineWidth = 1;
  bool offset = false;  // GL_POLYGON_OFFSET_FILL
  float offsetFactor = 0, offsetUnits = 0;
  std::shared_ptr<const BuiltInInputs> builtIn;  // replaces arrays and elements; null: the draw uses these
};

/// Captures the draw that is about to be made with the current state. All enabled arrays must be in buffers.
ProgramDraw captureProgramDraw(const RealGl& real, const Program& program, const UniformValuesPtr& uniforms,
                               const ArrayState& attributes, GLenum mode, const Elements& elements);
/// Captures a draw of fixed function's vertices. `instance` has the mesh, matrix and current values.
ProgramDraw captureBuiltInDraw(const RealGl& real, const KnownProgram& known,
                               const UniformValuesPtr& uniforms, scene::Instance instance);

}  // namespace gluray::gl
