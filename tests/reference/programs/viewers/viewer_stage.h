// What the tests of viewers' shader programs share: a bowl of which both sides are seen, its arrays, and both
// kinds of comparison.
#pragma once
#include "tests/reference/programs/program_mutants.h"

#include <functional>
#include <string>
#include <vector>

namespace gluray::test {

/// An open half of a ball. `colors`: a colour of floats at each vertex.
struct Bowl {
  ProgramMesh mesh;
  std::vector<glm::vec3> colors;
};
Bowl bowlWithColors();

/// An array of floats for the attribute `name` of the program, if it is active.
template <class T>
void setArray(Gl gl, GLuint program, const char* name, const std::vector<T>& values) {
  makeBuffer(gl, GL_ARRAY_BUFFER, values);
  const GLint place = gl.GetAttribLocation(program, name);
  if (place < 0) return;
  gl.EnableVertexAttribArray(static_cast<GLuint>(place));
  gl.VertexAttribPointer(static_cast<GLuint>(place), sizeof(T) / sizeof(float), GL_FLOAT, GL_FALSE, 0,
                         nullptr);
}

/// A new vertex array object with the bowl's indices; draw() ends with its draw.
struct BowlDraw {
  BowlDraw(Gl of, const Bowl& bowl);
  void draw(GLsizei instances = 0) const;
  Gl gl;
  GLsizei count;
};

using DrawViewer = std::function<void(Gl, GLuint program)>;
/// Draws the program by the real OpenGL and through GLuRay, traced, and expects the same image.
void expectTraced(const std::string& name, const std::string& vertex, const std::string& fragment,
                  const DrawViewer& draw, const scenes::Tolerance& tolerance = kProgramTolerance);
/// Draws it and expects the real OpenGL to do so.
void expectLeft(const std::string& name, const std::string& vertex, const std::string& fragment,
                const DrawViewer& draw);
void expectViewerMutantsSeen(const std::string& name, const std::string& vertex, const std::string& fragment,
                             const DrawViewer& draw);

}  // namespace gluray::test
