// Triangles that programs of no family draw, and where images show points: for tests of light on and from
// rasterised surfaces.
#pragma once
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test {

using Triangles = std::vector<glm::vec3>;

inline void addQuad(Triangles& to, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                    const glm::vec3& d) {
  to.insert(to.end(), {a, b, c, a, c, d});
}

/// How a program with the attribute "position" and the uniforms "clipFromEye", "eyeFromObject" and "tint"
/// draws them.
struct TrianglesLook {
  glm::mat4 clipFromEye, eyeFromObject;
  glm::vec3 tint;       // linear RGB, 0 to 1
  GLsizei indices = 0;  // of the bound ones, so many; 0: all triangles in their order
};

/// Draws them from a new buffer object.
inline void drawTriangles(Gl gl, GLuint program, const Triangles& triangles, const TrianglesLook& look) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec3)),
                triangles.data(), GL_STATIC_DRAW);
  const auto location = static_cast<GLuint>(gl.GetAttribLocation(program, "position"));
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.UseProgram(program);
  setMat4(gl, program, "clipFromEye", look.clipFromEye);
  setMat4(gl, program, "eyeFromObject", look.eyeFromObject);
  setVec3(gl, program, "tint", look.tint);
  if (look.indices > 0)
    gl.DrawElements(GL_TRIANGLES, look.indices, GL_UNSIGNED_INT, nullptr);
  else
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
  gl.DisableVertexAttribArray(location);
  gl.UseProgram(0);
}

struct CountedImage {
  DrawnImage image;
  gl::Statistics counts;
};

/// The last of so many frames that `frame` draws into a window of size x size pixels, and the counts of all.
inline CountedImage seenThrough(const Settings& settings, int size, const std::function<void(Gl)>& frame,
                                int frames = 1) {
  TracedContext context({size, size}, settings);
  Gl gl = context.gl();
  CountedImage result;
  for (int i = 0; i < frames; ++i) {
    frame(gl);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    result.image = readImage(gl, size, size);
  }
  result.counts = context.context().counts.statistics;
  return result;
}

/// Number of the pixel of a square image that shows a point in front of the viewer, inside the window.
inline size_t pixelOf(const DrawnImage& p, const glm::mat4& clipFromWorld, const glm::vec3& point) {
  const glm::vec4 clip = clipFromWorld * glm::vec4(point, 1);
  const glm::ivec2 pixel((glm::vec2(clip) / clip.w * 0.5f + 0.5f) * static_cast<float>(p.width));
  return static_cast<size_t>(pixel.y * p.width + pixel.x);
}

}  // namespace gluray::test
