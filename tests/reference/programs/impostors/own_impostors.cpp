#include "tests/reference/programs/impostors/own_impostors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace gluray::test {

GLuint linkImpostors(Gl gl, const std::string& vertex, const std::string& geometry,
                     const std::string& fragment) {
  const GLuint program = gl.CreateProgram();
  const std::pair<GLenum, const std::string&> parts[] = {
      {GL_VERTEX_SHADER, vertex}, {GL_GEOMETRY_SHADER, geometry}, {GL_FRAGMENT_SHADER, fragment}};
  for (const auto& [kind, text] : parts) {
    if (text.empty()) continue;
    const GLuint shader = gl.CreateShader(kind);
    const char* source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr), gl.CompileShader(shader), gl.AttachShader(program, shader);
    GLchar log[2000] = {};
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    EXPECT_STREQ(log, "");
  }
  gl.LinkProgram(program);
  return program;
}

void placeImpostors(Gl gl, GLuint program) {
  std::vector<float> places, paints;
  for (int i = 0; i < kImpostors; ++i) {
    const auto t = static_cast<float>(i);
    for (const float v : {std::sin(1.7f * t), std::sin(2.3f * t + 1), std::cos(0.9f * t)})
      places.push_back(v);
    for (const float v : {1.0f, 0.5f + 0.5f * std::sin(t), 0.3f}) paints.push_back(v);
  }
  GLuint array = 0;
  gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  addImpostorValues(gl, program, "place", 3, places), addImpostorValues(gl, program, "paint", 3, paints);
}

void addImpostorValues(Gl gl, GLuint program, const char* name, GLint size,
                       const std::vector<float>& values) {
  const GLint at = gl.GetAttribLocation(program, name);
  if (at < 0) return;
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * values.size()), values.data(), GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(static_cast<GLuint>(at));
  gl.VertexAttribPointer(static_cast<GLuint>(at), size, GL_FLOAT, false, 0, nullptr);
}

void lookAtImpostors(Gl gl, GLuint program, const View& view, bool parallel) {
  setMat4(gl, program, "projection", glm::mat4(view.clipFromEye));
  setMat4(gl, program, "modelview", glm::mat4(view.eyeFromObject));
  setInteger(gl, program, "ortho", parallel);
  setVec3(gl, program, "sun", glm::normalize(glm::vec3(-0.3f, -0.5f, -1)));
}

void drawNumbered(Gl gl, GLenum mode, const std::vector<GLushort>& numbers) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(2 * numbers.size()), numbers.data(),
                GL_STATIC_DRAW);
  gl.DrawElements(mode, static_cast<GLsizei>(numbers.size()), GL_UNSIGNED_SHORT, nullptr);
}

}  // namespace gluray::test
