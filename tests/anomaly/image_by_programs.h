// An image drawn by VTK's shader programs: colours at vertices and triangles, two cameras, a buffer
// that changes. Allocates nothing itself.
#pragma once
#include "tests/anomaly/image_of_all.h"

namespace gluray::test::anomaly {

inline constexpr const char* kSurfaceVertex =
    "#version 150\nin vec4 vertexMC;\nin vec4 scalarColor;\nout vec4 vertexColorVSOutput;\nuniform mat4 "
    "MCDCMatrix;\n"
    "void main() { vertexColorVSOutput = scalarColor; gl_Position = MCDCMatrix * vertexMC; }\n";
inline constexpr const char* kSurfaceFragment =
    "#version 150\nin vec4 vertexColorVSOutput;\nout vec4 fragOutput0;\nuniform float ambientIntensity;\n"
    "uniform vec3 ambientColorUniform;\nuniform vec3 diffuseColorUniform;\nuniform float diffuseIntensity;\n"
    "uniform float opacityUniform;\nuniform bool OverridesColor;\n"
    "void main() {\n  vec3 ambientColor = ambientIntensity * vertexColorVSOutput.rgb;\n"
    "  vec3 diffuseColor = diffuseIntensity * vertexColorVSOutput.rgb;\n"
    "  float opacity = opacityUniform * vertexColorVSOutput.a;\n"
    "  if (OverridesColor) {\n    ambientColor = ambientColorUniform * ambientIntensity;\n"
    "    diffuseColor = diffuseColorUniform * diffuseIntensity; }\n"
    "  fragOutput0 = vec4(ambientColor + diffuseColor, opacity); }\n";
inline constexpr const char* kCellVertex =
    "#version 150\nin vec4 vertexMC;\nuniform mat4 MCDCMatrix;\nvoid main() { gl_Position = MCDCMatrix * "
    "vertexMC; }\n";
inline constexpr const char* kCellFragment =
    "#version 150\n#define texelFetchBuffer texelFetch\nout vec4 fragOutput0;\nuniform samplerBuffer "
    "textureC;\n"
    "uniform int PrimitiveIDOffset;\nuniform float ambientIntensity;\nuniform vec3 ambientColorUniform;\n"
    "uniform vec3 diffuseColorUniform;\nuniform float diffuseIntensity;\nuniform float opacityUniform;\n"
    "uniform bool OverridesColor;\n"
    "void main() {\n  vec4 texColor = texelFetchBuffer(textureC, gl_PrimitiveID + PrimitiveIDOffset);\n"
    "  vec3 ambientColor = ambientIntensity * texColor.rgb;\n"
    "  vec3 diffuseColor = diffuseIntensity * texColor.rgb;\n"
    "  float opacity = opacityUniform * texColor.a;\n"
    "  if (OverridesColor) {\n    ambientColor = ambientColorUniform * ambientIntensity;\n"
    "    diffuseColor = diffuseColorUniform * diffuseIntensity; }\n"
    "  fragOutput0 = vec4(ambientColor + diffuseColor, opacity); }\n";

inline GLuint linked(Gl gl, const char* vertex, const char* fragment) {
  const GLuint program = gl.CreateProgram();
  const char* texts[] = {vertex, fragment};
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = gl.CreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
    gl.ShaderSource(shader, 1, &texts[i], nullptr);
    gl.CompileShader(shader), gl.AttachShader(program, shader);
  }
  gl.BindAttribLocation(program, 0, "vertexMC"), gl.BindAttribLocation(program, 1, "scalarColor");
  gl.LinkProgram(program);
  gl.UseProgram(program);
  for (const char* name : {"diffuseIntensity", "opacityUniform"})
    gl.Uniform1f(gl.GetUniformLocation(program, name), 1);
  return program;
}

inline void place(Gl gl, GLuint program, GLfloat x, GLfloat y, GLfloat z, GLfloat scale) {
  const GLfloat matrix[16] = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, x, y, z, 1};
  gl.UniformMatrix4fv(gl.GetUniformLocation(program, "MCDCMatrix"), 1, GL_FALSE, matrix);
}

inline void drawByPrograms(Gl gl) {
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST), gl.ClearColor(0.1f, 0.2f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  GLuint buffers[4], array = 0, cells = 0;
  gl.GenBuffers(4, buffers), gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof kPositions, kPositions, GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(0), gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof kColors, kColors, GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(1), gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kIndices, kIndices, GL_STATIC_DRAW);

  const GLuint surface = linked(gl, kSurfaceVertex, kSurfaceFragment);
  place(gl, surface, 0, 0, 0, 1);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  place(gl, surface, 0.4f, 0.4f, -0.4f, 0.4f);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);

  const GLuint cell = linked(gl, kCellVertex, kCellFragment);
  gl.BindBuffer(GL_TEXTURE_BUFFER, buffers[3]);
  gl.BufferData(GL_TEXTURE_BUFFER, sizeof kColors, kColors, GL_STATIC_DRAW);
  gl.GenTextures(1, &cells), gl.BindTexture(GL_TEXTURE_BUFFER, cells);
  gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA8, buffers[3]);
  place(gl, cell, -0.5f, 0.5f, -0.3f, 0.4f);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  gl.Viewport(kSize / 2, 0, kSize / 2, kSize / 2);
  gl.Uniform1i(gl.GetUniformLocation(cell, "PrimitiveIDOffset"), 2);
  place(gl, cell, 0, 0, -0.6f, 0.9f);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  gl.Viewport(0, 0, kSize, kSize);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, 12, kPositions + 9);  // after the pending draws
  gl.UseProgram(surface);
  place(gl, surface, -0.6f, -0.6f, -0.5f, 0.3f);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  gl.Finish();
}

}  // namespace gluray::test::anomaly
