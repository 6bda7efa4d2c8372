// Absurd input: nothing here may crash, hang, or leave the context unable to draw the next image.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;

void trianglePlaced(Gl gl, float x, float y, float z) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(x - 0.5f, y - 0.5f, z), gl.Vertex3f(x + 0.5f, y - 0.5f, z), gl.Vertex3f(x, y + 0.5f, z + 0.1f);
  gl.End();
}

struct Abuse {
  const char* name;
  void (*calls)(Gl);
};

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

const Abuse kAbuses[] = {
    {"not a number", [](Gl gl) { trianglePlaced(gl, kNan, 0, 0), trianglePlaced(gl, 0, kNan, kNan); }},
    {"infinite vertices",
     [](Gl gl) { trianglePlaced(gl, kInf, -kInf, kInf), trianglePlaced(gl, 0, 0, -kInf); }},
    {"largest floats", [](Gl gl) { trianglePlaced(gl, 3e38f, -3e38f, 3e38f); }},
    {"degenerate triangles",
     [](Gl gl) {
       gl.Begin(GL_TRIANGLES);
       for (int i = 0; i < 30; ++i) gl.Vertex3f(0.1f, 0.1f, 0.1f);
       gl.End();
     }},
    {"matrices of nonsense",
     [](Gl gl) {
       const GLfloat m[16] = {kNan, kInf, 0, 1, -kInf, 3, kNan, 0, 0, 0, 0, 0, 1e38f, -1e38f, 0, 0};
       gl.LoadMatrixf(m), trianglePlaced(gl, 0, 0, 0);
     }},
    {"matrix without inverse", [](Gl gl) { gl.Scalef(0, 1, 1), trianglePlaced(gl, 0, 0, 0); }},
    {"viewport without area", [](Gl gl) { gl.Viewport(0, 0, 0, 0), trianglePlaced(gl, 0, 0, 0); }},
    {"viewport beyond everything",
     [](Gl gl) {
       gl.Viewport(-1000000000, -1000000000, 2000000000, 2000000000), trianglePlaced(gl, 0, 0, 0);
     }},
    {"depth range upside down and empty",
     [](Gl gl) {
       gl.DepthRange(1, 0), trianglePlaced(gl, 0, 0, 0), gl.DepthRange(0.5, 0.5), trianglePlaced(gl, 0, 0, 0);
     }},
    {"offset of nonsense",
     [](Gl gl) {
       gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(kNan, kInf), trianglePlaced(gl, 0, 0, 0);
     }},
    {"index out of range",
     [](Gl gl) {
       static const GLfloat positions[9] = {-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0, 0.5f, 0.1f};
       static const GLuint indices[6] = {0, 1, 2, 0, 4000000000u, 7};
       GLuint buffers[2];
       gl.GenBuffers(2, buffers);
       gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]),
           gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
       gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
       gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
       gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
     }},
    {"more indices than the buffer has",
     [](Gl gl) {
       static const GLfloat positions[9] = {};
       static const GLuint indices[3] = {0, 1, 2};
       GLuint buffers[2];
       gl.GenBuffers(2, buffers);
       gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]),
           gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
       gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
       gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
       gl.DrawElements(GL_TRIANGLES, std::numeric_limits<GLsizei>::max(), GL_UNSIGNED_INT, nullptr);
     }},
    {"2^31 vertices of a small buffer",
     [](Gl gl) {
       static const GLfloat positions[9] = {};
       GLuint buffer;
       gl.GenBuffers(1, &buffer);
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer),
           gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
       gl.DrawArrays(GL_TRIANGLES, 0, std::numeric_limits<GLsizei>::max());
     }},
    {"arrays without memory",
     [](Gl gl) {
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, nullptr),
           gl.DrawArrays(GL_TRIANGLES, 0, 3);
     }},
    {"lists in a ring",
     [](Gl gl) {
       gl.NewList(3, GL_COMPILE), gl.CallList(4), gl.EndList();
       gl.NewList(4, GL_COMPILE), gl.CallList(3), trianglePlaced(gl, 0, 0, 0), gl.EndList();
       gl.CallList(3);
     }},
    {"list deleted while compiled and called",
     [](Gl gl) {
       gl.NewList(5, GL_COMPILE), gl.DeleteLists(5, 1), trianglePlaced(gl, 0, 0, 0), gl.EndList();
       gl.CallList(5), gl.DeleteLists(1, std::numeric_limits<GLsizei>::max()), gl.CallList(5);
     }},
    {"begin left open",
     [](Gl gl) { gl.Begin(GL_TRIANGLES), gl.Vertex2f(0, 0), gl.Clear(GL_COLOR_BUFFER_BIT), gl.End(); }},
    {"stacks run over",
     [](Gl gl) {
       for (int i = 0; i < 200; ++i)
         gl.PushMatrix(), gl.PushAttrib(GL_ALL_ATTRIB_BITS), gl.PushClientAttrib(~0u);
       trianglePlaced(gl, 0, 0, 0);
       for (int i = 0; i < 300; ++i) gl.PopMatrix(), gl.PopAttrib(), gl.PopClientAttrib();
     }},
    {"lights of nonsense",
     [](Gl gl) {
       const GLfloat p[4] = {kNan, kInf, 0, 0};
       gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
       gl.Lightfv(GL_LIGHT0, GL_POSITION, p), gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, p),
           trianglePlaced(gl, 0, 0, 0);
     }},
};

TEST(Abuse, NeverStopsTheNextImage) {
  for (const Abuse& abuse : kAbuses) {
    SCOPED_TRACE(abuse.name);
    TracedContext context({32, 32});
    Gl gl = context.gl();
    gl.Enable(GL_DEPTH_TEST);
    abuse.calls(gl);
    gl.Finish();
    while (gl.GetError() != GL_NO_ERROR) {}
    // A plain triangle in the middle, after the state was reset.
    gl.PopAttrib(), gl.Disable(GL_LIGHTING), gl.Disable(GL_POLYGON_OFFSET_FILL), gl.DepthRange(0, 1),
        gl.Viewport(0, 0, 32, 32);
    gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity(), gl.Color3f(0, 1, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    trianglePlaced(gl, 0, 0, 0);
    uint32_t pixel = 0;
    gl.ReadPixels(16, 14, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    EXPECT_EQ(pixel, 0xFF00FF00u);
  }
}

}  // namespace
}  // namespace gluray::test
