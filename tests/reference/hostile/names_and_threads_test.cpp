// Twenty habits of real programs that break a naive interceptor. Habits 14 to 20: tiny draws, names,
// transparency, lines, clipping, passes, unchanged frames.
#include "tests/reference/hostile/habits.h"

#include <array>
#include <cmath>
#include <vector>

namespace gluray::test::twenty_points {
namespace {

TEST(TwentyPoints, P14ThousandsOfTinyDraws) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    const Model m = torus(0.9f, 0.3f, 60, 40);
    for (size_t t = 0; t < m.indices.size(); t += 3) {
      gl.Begin(GL_TRIANGLES);
      for (size_t k = 0; k < 3; ++k) {
        gl.Normal3fv(&m.normals[3 * m.indices[t + k]]);
        gl.Vertex3fv(&m.positions[3 * m.indices[t + k]]);
      }
      gl.End();
    }
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    send(gl, sphere(4, 6));
    gl.EndList();
    for (int i = 0; i < 400; ++i) {
      gl.PushMatrix();
      gl.Translatef(-1.3f + 0.13f * static_cast<float>(i % 20), -0.8f + 0.08f * static_cast<float>(i / 20),
                    -1);
      gl.Scalef(0.05f, 0.05f, 0.05f);
      gl.CallList(list);
      gl.PopMatrix();
    }
  });
  EXPECT_LE(s.flushes, 1u);
  EXPECT_LE(s.blasBuilds, 3u) << "small draws are not merged, or repeated lists not shared";
}

TEST(TwentyPoints, P15NamesAreUsedAgain) {
  expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    for (int round = 0; round < 3; ++round) {
      gl.NewList(5, GL_COMPILE);
      round % 2 ? send(gl, torus(0.3f, 0.1f, 16, 8)) : send(gl, sphere(8, 12));
      gl.EndList();
      gl.PushMatrix();
      gl.Translatef(-0.9f + 0.9f * static_cast<float>(round), 0, 0), gl.Scalef(0.6f, 0.6f, 0.6f);
      gl.CallList(5);
      gl.PopMatrix();
      gl.DeleteLists(5, 1);
      gl.CallList(5);  // nothing
      seen.push_back(gl.IsList(5));
      const GLfloat triangle[] = {
          -0.5f, -0.9f, 0.1f, 0.5f, -0.9f, 0.2f, 0, -0.6f + 0.1f * static_cast<float>(round), 0};
      GLuint buffer = 77;
      gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
      gl.BufferData(GL_ARRAY_BUFFER, sizeof triangle, triangle, GL_STATIC_DRAW);
      gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
      gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
      gl.DisableClientState(GL_VERTEX_ARRAY);
      gl.DeleteBuffers(1, &buffer);
      seen.push_back(gl.IsBuffer(77));
    }
  });
}

TEST(TwentyPoints, P16TransparencyOverTheTracedImage) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    send(gl, sphere(16, 24));
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    sendAt(gl, torus(0.8f, 0.2f, 30, 16), 0.3f, 0, 0, 1);  // blending on, alpha 1
    gl.DepthMask(GL_FALSE);
    for (int i = 0; i < 3; ++i) {  // sorted, back to front
      material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.2f, 0.3f * static_cast<float>(i), 0.9f, 0.4f});
      sendAt(gl, sphere(10, 16), 0.3f * static_cast<float>(i), 0.1f, -0.5f + 0.8f * static_cast<float>(i),
             0.5f);
    }
    gl.BlendFunc(GL_ONE, GL_ONE);  // glow
    sendAt(gl, sphere(10, 16), -0.6f, 0.3f, 0.9f, 0.3f);
    gl.DepthMask(GL_TRUE), gl.Disable(GL_BLEND);
    std::array<GLubyte, 128> screen;
    for (size_t i = 0; i < screen.size(); ++i) screen[i] = i / 4 % 2 ? 0x55 : 0xaa;
    gl.PolygonStipple(screen.data());
    gl.Enable(GL_POLYGON_STIPPLE);
    sendAt(gl, sphere(10, 16), 0.6f, -0.5f, 1, 0.4f);
    gl.Disable(GL_POLYGON_STIPPLE);
    gl.Enable(GL_ALPHA_TEST), gl.AlphaFunc(GL_GREATER, 0.3f);
    sendAt(gl, sphere(10, 16), -0.9f, -0.5f, 0.5f, 0.3f);
  });
  EXPECT_EQ(s.drawsTraced, 7u);
}

TEST(TwentyPoints, P17CoplanarLinesWin) {
  const gl::Statistics s = expectSame(
      [](Gl gl, Seen&) {
        stage(gl);
        const Model m = sphere(12, 18);
        gl.Enable(GL_POLYGON_OFFSET_FILL);
        gl.PolygonOffset(1, 1);
        send(gl, m);
        gl.Disable(GL_POLYGON_OFFSET_FILL), gl.Disable(GL_LIGHTING);
        gl.Color3f(0, 0, 0);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        send(gl, m, 0);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        gl.DepthRange(0, 0.9);
        gl.Color3f(1, 1, 0);
        gl.Begin(GL_LINES);
        for (const float x : {-0.5f, 0.0f, 0.5f}) gl.Vertex3f(x, -1, 0), gl.Vertex3f(x, 1, 0);
        gl.End();
      },
      {{2, 0.002, 1e-5f,
        "lines lie in the surface but for the offset: a few pixels fall to the other side"}});
  EXPECT_EQ(s.blasBuilds, 1u) << "the surface under its lines is not traced";
}

TEST(TwentyPoints, P18SixClipPlanesAsABox) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Rotatef(25, 0, 1, 0);
    for (int i = 0; i < 6; ++i) {
      GLdouble plane[4] = {0, 0, 0, 0.62};
      plane[i / 2] = i % 2 ? 1 : -1;
      gl.ClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), plane);
      gl.Enable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
    }
    gl.Rotatef(-40, 1, 0, 0);  // the planes stay where they were
    send(gl, sphere(24, 36));
    gl.Disable(GL_CLIP_PLANE3);
    paint(gl, 0.3f, 0.5f, 0.9f);
    sendAt(gl, torus(0.6f, 0.2f, 30, 16), 0, 0.4f, 0.2f, 1);
  });
  EXPECT_EQ(s.trianglesRasterised, 0u);
}

TEST(TwentyPoints, P19MultiPassTechniquesAreRasterised) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    send(gl, sphere(16, 24));
    gl.ClearStencil(0), gl.Clear(GL_STENCIL_BUFFER_BIT);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE), gl.DepthMask(GL_FALSE);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_ALWAYS, 0, 255), gl.StencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    sendAt(gl, torus(0.8f, 0.3f, 30, 16), 0.3f, 0, 0.3f, 1);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), gl.DepthMask(GL_TRUE);
    gl.StencilFunc(GL_NOTEQUAL, 0, 255), gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.DepthFunc(GL_GREATER);
    paint(gl, 0.2f, 0.9f, 0.9f);
    sendAt(gl, sphere(16, 24), 0, 0, -0.3f, 1);
    gl.Disable(GL_STENCIL_TEST), gl.DepthFunc(GL_LESS);
    sendAt(gl, sphere(8, 12), -0.9f, 0.4f, 1, 0.3f);
  });
  EXPECT_EQ(s.drawsTraced, 2u);
  EXPECT_EQ(s.drawsRasterised, 2u);
}

TEST(TwentyPoints, P20UnchangedFramesBuildNothing) {
  TracedContext ours({kWidth, kHeight});
  const Model m = torus(0.9f, 0.3f, 60, 40);
  DrawnImage first;
  uint64_t builds = 0, meshes = 0;
  for (int frame = 0; frame < 20; ++frame) {
    stage(ours.gl());
    send(ours.gl(), m);
    const DrawnImage now = ours.read();
    const gl::Statistics& s = ours.context().counts.statistics;
    if (frame == 0) first = now, builds = s.blasBuilds, meshes = s.meshesBuilt;
    EXPECT_TRUE(now == first) << "frame " << frame;
    EXPECT_EQ(s.blasBuilds, builds);
    EXPECT_EQ(s.meshesBuilt, meshes) << "an unchanged run was not recognised in frame " << frame;
  }
}

}  // namespace
}  // namespace gluray::test::twenty_points
