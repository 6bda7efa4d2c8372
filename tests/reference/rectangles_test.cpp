// Rectangles that the real OpenGL draws: their values at the pixels depend on where it splits them.
#include "tests/reference/both.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

/// A ground whose pattern is so fine that the last bits of interpolated coordinates show.
constexpr const char* kGround = R"(#version 120
varying vec3 at;
void main() {
  at = vec3(40.0 * gl_Vertex.x, -2.0, 40.0 * gl_Vertex.y - 45.0);
  gl_Position = vec4(2.0 * at.xy, -at.z - 0.2, -at.z);
})";
constexpr const char* kPattern = R"(#version 120
varying vec3 at;
void main() { gl_FragColor = vec4(fract(37.0 * at.xz), fract(at.x * at.z), 1.0); }
)";

void expectExact(const std::string& name, const Draw& draw) {
  const BothStage stage{
      .folder = "rectangles",
      .prepare =
          [](scenes::Gl gl) {
            gl.UseProgram(makeProgram(gl, kGround, kPattern));
            gl.Enable(GL_DEPTH_TEST);
            gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          },
      .tolerance = {.color = 0, .edgeShare = 0, .depth = 0, .reason = "one OpenGL draws both"}};
  compareBoth(stage, name, draw);
}

TEST(Rectangles, OfShaderProgramsAreThoseOfTheRealOpenGl) {
  expectExact("calls", [](scenes::Gl gl) { gl.Rectf(-1, -1, 1, 1); });
  expectExact("numbers", [](scenes::Gl gl) {
    const GLshort corners[] = {-1, -1, 1, 1};
    gl.Rectsv(corners, corners + 2);
  });
  expectExact("list", [](scenes::Gl gl) {
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.Rectf(-1, -1, 1, 1);
    gl.EndList();
    gl.CallList(list);
  });
}

}  // namespace
}  // namespace gluray::test
