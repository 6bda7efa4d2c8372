#include "intercept/present/read_back/view_program.h"

#include "gl/glsl/build_program.h"

#include <GL/glext.h>

namespace gluray::present {
namespace {

using gl::RealGl;

constexpr const char* kGivenVertices =
    "#version 150 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n";

/// A triangle around the view.
constexpr const char* kTriangleAround = R"(#version 150
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

}  // namespace

GLuint buildViewProgram(const RealGl& real, bool compatibility, const char* fragmentShader) {
  return gl::buildProgram(real, {{GL_VERTEX_SHADER, compatibility ? kGivenVertices : kTriangleAround},
                                 {GL_FRAGMENT_SHADER, fragmentShader}});
}

void drawAroundView(const RealGl& real, bool compatibility) {
  if (!compatibility) return real.DrawArrays(GL_TRIANGLES, 0, 3);
  // glVertex changes no current value and needs no array state.
  real.Begin(GL_TRIANGLES);
  real.Vertex2f(-1, -1), real.Vertex2f(3, -1), real.Vertex2f(-1, 3);
  real.End();
}

}  // namespace gluray::present
