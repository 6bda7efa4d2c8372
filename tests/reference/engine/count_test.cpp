// The report counts every triangle that the real OpenGL draws, however it was sent.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace gluray::test {
namespace {

struct Sent {
  GLenum mode;
  GLsizei vertices;
  uint64_t triangles;
};

constexpr Sent kSent[] = {
    {GL_TRIANGLES, 7, 2}, {GL_TRIANGLE_STRIP, 7, 5}, {GL_TRIANGLE_FAN, 6, 4},
    {GL_QUADS, 9, 4},     {GL_QUAD_STRIP, 8, 6},     {GL_POLYGON, 6, 4},
    {GL_LINE_LOOP, 6, 0}, {GL_POINTS, 5, 0},         {GL_TRIANGLES, 2, 0},
};

/// Positions of vertices on a slanted circle.
const std::vector<GLfloat>& positions() {
  static const std::vector<GLfloat> once = [] {
    std::vector<GLfloat> values;
    for (int i = 0; i < 300; ++i) {
      const float t = static_cast<float>(i);
      values.insert(values.end(), {0.9f * std::cos(t), 0.9f * std::sin(t), 0.1f * std::cos(2 * t)});
    }
    return values;
  }();
  return once;
}

class Rasterised : public testing::Test {
 protected:
  Rasterised() {
    gl().Enable(GL_STENCIL_TEST);
    gl().VertexPointer(3, GL_FLOAT, 0, positions().data());
  }
  const gl::RealGl& gl() const { return context_.gl(); }
  /// Triangles and draws counted as rasterised while `draw` runs.
  void expect(uint64_t triangles, uint64_t draws, const char* what, const std::function<void()>& draw) {
    const gl::Statistics& s = context_.context().counts.statistics;
    const uint64_t trianglesBefore = s.trianglesRasterised, drawsBefore = s.drawsRasterised;
    draw();
    gl().Finish();
    EXPECT_EQ(s.trianglesRasterised - trianglesBefore, triangles) << what;
    EXPECT_EQ(s.drawsRasterised - drawsBefore, draws) << what;
    EXPECT_EQ(s.trianglesTraced, 0u) << what;
  }
  TracedContext context_;
};

TEST_F(Rasterised, ImmediateModeIsCounted) {
  for (const Sent& sent : kSent)
    expect(sent.triangles, 1, "glVertex", [&] {
      gl().Begin(sent.mode);
      for (GLsizei i = 0; i < sent.vertices; ++i)
        i % 2 ? gl().Vertex3fv(&positions()[static_cast<size_t>(3 * i)])
              : gl().Vertex4f(positions()[static_cast<size_t>(3 * i)], 0, 0, 2);
      gl().End();
    });
}

TEST_F(Rasterised, ArraysAreCountedByPrimitive) {
  gl().EnableClientState(GL_VERTEX_ARRAY);
  const GLubyte indices[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (const Sent& sent : kSent) {
    expect(sent.triangles, 1, "glDrawArrays", [&] { gl().DrawArrays(sent.mode, 0, sent.vertices); });
    expect(sent.triangles, 1, "glDrawElements",
           [&] { gl().DrawElements(sent.mode, sent.vertices, GL_UNSIGNED_BYTE, indices); });
    expect(sent.triangles, 1, "glArrayElement", [&] {
      gl().Begin(sent.mode);
      for (GLsizei i = 0; i < sent.vertices; ++i) gl().ArrayElement(i);
      gl().End();
    });
  }
  expect(298, 1, "a long strip", [&] { gl().DrawArrays(GL_TRIANGLE_STRIP, 0, 300); });
}

TEST_F(Rasterised, ListsAreCountedWhenTheyAreCalled) {
  gl().NewList(1, GL_COMPILE);
  gl().Begin(GL_QUADS);
  for (int i = 0; i < 8; ++i) gl().Vertex3fv(&positions()[static_cast<size_t>(3 * i)]);
  gl().End();
  expect(0, 0, "compiling", [&] { gl().EndList(); });
  expect(8, 2, "called twice", [&] { gl().CallList(1), gl().CallList(1); });
}

}  // namespace
}  // namespace gluray::test
