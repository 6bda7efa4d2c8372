// An image drawn by all ways of sending geometry, and its comparison with the real OpenGL's. The program
// under test itself allocates nothing: static data, no containers.
#pragma once
#include "tests/support/traced_context.h"

namespace gluray::test::anomaly {

using Gl = const gl::RealGl&;
inline constexpr int kSize = 32;

inline constexpr GLfloat kPositions[] = {-0.9f, -0.9f, 0.1f, 0.1f, -0.9f, 0.2f,
                                         -0.4f, 0.9f,  0.4f, 0.9f, 0.5f,  -0.2f};
inline constexpr GLubyte kColors[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
inline constexpr GLuint kIndices[] = {0, 1, 2, 2, 1, 3};

inline void immediate(Gl gl) {
  gl.Begin(GL_TRIANGLES);
  for (const GLuint i : kIndices) gl.Color4ubv(kColors + 4 * i), gl.Vertex3fv(kPositions + 3 * i);
  gl.End();
}

inline void drawAll(Gl gl) {
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST), gl.ClearColor(0.1f, 0.2f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.ShadeModel(GL_FLAT);
  immediate(gl);
  gl.NewList(1, GL_COMPILE), gl.Scalef(0.5f, 0.5f, 0.5f), immediate(gl), gl.EndList();
  gl.PushMatrix(), gl.Translatef(0.3f, 0.3f, -0.5f), gl.CallList(1), gl.PopMatrix();
  gl.NewList(2, GL_COMPILE_AND_EXECUTE), gl.Translatef(-0.2f, 0, -0.1f), immediate(gl), gl.EndList();
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, kPositions), gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, kColors);
  gl.Translatef(0.1f, -0.3f, -0.2f), gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, kIndices);
  gl.Begin(GL_LINES), gl.Vertex3f(-1, -1, -0.9f), gl.Vertex3f(1, 1, -0.9f), gl.End();
  gl.Finish();
}

/// Whether a colour stands at (x, y) of `image` or beside it: edges of traced and rasterised triangles may
/// differ by a pixel.
inline bool isNear(const DrawnImage& image, int x, int y, uint32_t color) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int px = x + dx, py = y + dy;
      if (px < 0 || py < 0 || px >= kSize || py >= kSize) continue;
      if (image.colors[static_cast<size_t>(py * kSize + px)] == color) return true;
    }
  return false;
}

/// Pixels of `got` that are nowhere near those of `expected`.
inline int wrongPixels(const DrawnImage& expected, const DrawnImage& got) {
  int wrong = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      wrong += !isNear(expected, x, y, got.colors[static_cast<size_t>(y * kSize + x)]);
  return wrong;
}

/// The real OpenGL's image.
inline DrawnImage expectedImage() {
  const auto real = OsmesaContext::create({kSize, kSize});
  drawAll(real->real());
  return readImage(real->real(), kSize, kSize);
}

}  // namespace gluray::test::anomaly
