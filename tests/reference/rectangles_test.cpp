// Rectangles and quads that the real OpenGL draws: their values at the pixels depend on where it splits them.
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

/// A few quads whose colours show the diagonal, without depth test: GLuRay leaves them to the real OpenGL.
TEST(Quads, WithIndicesAreSplitAsWithoutGluray) {
  static constexpr float kPlaces[] = {-0.9f, -0.9f, -0.1f, -0.9f, -0.1f, 0.9f, -0.9f, 0.9f,
                                      0.1f,  -0.9f, 0.9f,  -0.9f, 0.9f,  0.9f, 0.1f,  0.9f};
  static constexpr float kColors[] = {1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1};
  static constexpr GLushort kIndices[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto draw = [](bool indices) {
    return [indices](scenes::Gl gl) {
      gl.VertexPointer(2, GL_FLOAT, 0, kPlaces), gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.ColorPointer(3, GL_FLOAT, 0, kColors), gl.EnableClientState(GL_COLOR_ARRAY);
      if (indices)
        gl.DrawElements(GL_QUADS, 8, GL_UNSIGNED_SHORT, kIndices);
      else
        gl.DrawArrays(GL_QUADS, 0, 8);
      gl.DisableClientState(GL_VERTEX_ARRAY), gl.DisableClientState(GL_COLOR_ARRAY);
    };
  };
  const BothStage stage{
      .folder = "rectangles",
      .prepare = [](scenes::Gl gl) { gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); },
      .tolerance = {.color = 0, .edgeShare = 0, .depth = 0, .reason = "one OpenGL draws both"}};
  compareBoth(stage, "quads_with_indices", draw(true));
  compareBoth(stage, "quads_without_indices", draw(false));
}

}  // namespace
}  // namespace gluray::test
