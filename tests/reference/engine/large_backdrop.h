// A surface that is too large for the real OpenGL to be tried.
#pragma once
#include "scenes/stage.h"
#include "tests/reference/drawn_scene.h"

#include <GL/gl.h>

#include <cmath>
#include <vector>

namespace gluray::test {

/// So many triangles that GLuRay does not try the real OpenGL, in the far background.
inline void backdrop(scenes::Gl gl) {
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.MatrixMode(GL_PROJECTION), gl.PushMatrix();
  scenes::begin(gl, kSceneWidth, kSceneHeight);
  scenes::camera(gl, kSceneWidth, kSceneHeight);
  for (const GLenum off :
       {GL_LIGHTING, GL_BLEND, GL_STENCIL_TEST, GL_ALPHA_TEST, GL_POLYGON_STIPPLE, GL_SCISSOR_TEST})
    gl.Disable(off);
  gl.DepthFunc(GL_LESS), gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  static const std::vector<GLfloat> corners = [] {
    constexpr int kSquares = 130;
    std::vector<GLfloat> v;
    const auto put = [&](int x, int y) {
      const float u = 4.0f * static_cast<float>(x) / kSquares - 2,
                  w = 4.0f * static_cast<float>(y) / kSquares - 2;
      v.insert(v.end(), {u, w, -1 + 0.3f * std::sin(3 * u) * std::cos(2 * w)});
    };
    for (int y = 0; y < kSquares; ++y)
      for (int x = 0; x < kSquares; ++x)
        put(x, y), put(x + 1, y), put(x + 1, y + 1), put(x, y), put(x + 1, y + 1), put(x, y + 1);
    return v;
  }();
  gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  for (const GLenum off : {GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
    gl.DisableClientState(off);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.VertexPointer(3, GL_FLOAT, 0, corners.data());
  gl.Color3f(0.5f, 0.5f, 0.4f);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / 3));
  gl.PopClientAttrib();
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
  gl.MatrixMode(GL_PROJECTION), gl.PopMatrix();
  gl.PopAttrib();
}

}  // namespace gluray::test
