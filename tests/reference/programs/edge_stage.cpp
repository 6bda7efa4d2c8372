// Uniforms of programs that paint edges.
#include "tests/reference/programs/program_stage.h"

namespace gluray::test {

void setEdges(Gl gl, GLuint program) {
  setFloat(gl, program, "lineWidth", 2), setFloat(gl, program, "edgeOpacity", 0.7f);
  setVec3(gl, program, "edgeColor", {0.8f, 0.1f, 0.1f});
  gl.Uniform4f(gl.GetUniformLocation(program, "vpDims"), 0, 0, kProgramWidth, kProgramHeight);
}

}  // namespace gluray::test
