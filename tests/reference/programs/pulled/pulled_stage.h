// A stage for programs that pull vertices from buffer textures (pulled_text.h). For program_pulled_test.cpp.
#pragma once
#include "tests/reference/programs/program_stage.h"
#include "tests/support/pulled_text.h"

namespace gluray::test {

/// How a mesh lies in the buffers, and what the program's uniforms say.
struct PulledWay {
  GLint pointsBefore = 0, verticesBefore = 0;  // of other meshes in the same buffers
  GLint cellsBefore = 0, trianglesBefore = 0, flagsBefore = 0;
  bool quads = false;    // two triangles are a cell
  bool indexed = false;  // by glDrawElementsInstanced
  bool edges = false, flagged = false;
  bool wireframe = false;  // edges alone
  float edgeOpacity = 1;
  float opacity = 1;
  bool lit = true;
  bool overrides = false;  // blocks have colours that replace all others
};

/// What a program's uniforms let it draw of the same buffers: each vertex as a point, of cells of one, two or
/// three vertices, or each two vertices as a line. There are as many cells as the mesh has triangles.
enum class PulledKind { vertices, ends, corners, lines };

GLuint makeProgram(Gl gl, const PulledSurface& surface);

/// The buffer textures of a mesh on texture units of their own.
class PulledMesh {
 public:
  PulledMesh(Gl gl, const ProgramMesh& mesh, const PulledWay& way, bool scalars);
  /// Uses the program, sets all its uniforms.
  void set(Gl gl, GLuint program, const View& view, const PulledSurface& surface) const;
  /// Draws by the program in use.
  void draw(Gl gl) const;
  /// Draws spheres or tubes of `pixels` by the program in use. Changes its uniforms.
  void drawSolids(Gl gl, GLuint program, PulledKind kind, const View& view, float pixels) const;
  /// Replaces the position of a point.
  void move(Gl gl, size_t point, const glm::vec3& to) const;
  /// Replaces the colours of some cells from `cell` on, or lets triangles from `cell` on be of the first one.
  void recolor(Gl gl, size_t cell) const;
  void regroup(Gl gl, size_t cell) const;

 private:
  PulledWay way_;
  GLsizei count_;
  GLuint positions_ = 0, array_ = 0, cells_ = 0, cellColors_ = 0;
};

}  // namespace gluray::test
