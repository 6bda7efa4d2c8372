// Culled draws of programs without attributes, which no family describes: the shader fetches its vertices by
// gl_VertexID, and the real OpenGL feeds their positions back.
#include "tests/reference/culled/culled_frames.h"
#include "tests/reference/culled/culled_programs.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::test {
namespace {

using namespace culled;

TEST(PulledDraws, AreCulled) {
  const std::string vertex = replacedIn(
      replacedIn(kCulledVertex, "in vec3 position;\nin vec3 normal;",
                 "uniform samplerBuffer positions, normals;\nuniform isamplerBuffer points;"),
      "void main() {",
      "void main() {\n  int point = texelFetch(points, gl_VertexID).x;\n"
      "  vec3 position = texelFetch(positions, point).xyz, normal = texelFetch(normals, point).xyz;");
  const ProgramMesh mesh = shells(5, 100);
  GLuint program = 0;
  const auto texture = [&](Gl gl, const char* name, GLint unit, GLenum format, const auto& values) {
    const GLuint filled = makeBuffer(gl, GL_TEXTURE_BUFFER, values);
    GLuint made = 0;
    gl.GenTextures(1, &made);
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_BUFFER, made), gl.TexBuffer(GL_TEXTURE_BUFFER, format, filled);
    gl.Uniform1i(gl.GetUniformLocation(program, name), unit);
  };
  const gl::Statistics counts = compareFrames(
      "pulled_culled", 5,
      [&](Gl gl) {
        GLuint empty = 0;
        gl.GenVertexArrays(1, &empty), gl.BindVertexArray(empty);
        program = makeProgram(gl, vertex, kCulledFragment);
        gl.UseProgram(program);
        texture(gl, "positions", 0, GL_RGB32F, mesh.positions);
        texture(gl, "normals", 1, GL_RGB32F, mesh.normals), texture(gl, "points", 2, GL_R32I, mesh.indices);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program);
        turn(gl, program, frame);
        gl.DrawArraysInstanced(GL_TRIANGLES, 0, mesh.count(), 1);
      },
      nullptr, {kSide, kSide, true, 3, 2});
  EXPECT_EQ(counts.drawsCulled, 4u);
  EXPECT_GT(counts.trianglesLeftOut, 4 * mesh.triangles() / 3);
}

}  // namespace
}  // namespace gluray::test
