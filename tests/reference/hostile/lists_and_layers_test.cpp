// Twenty habits of real programs that break a naive interceptor. Habits 1 to 8: lists, layers, clears, text.
// Those that need a window are in tests/doors.
#include "tests/reference/hostile/habits.h"

#include <array>
#include <cmath>
#include <vector>

namespace gluray::test::twenty_points {
namespace {

/// One letter as glBitmap takes it, 8 x 8 pixels.
void label(Gl gl, float x, float y, float z) {
  constexpr GLubyte kLetter[] = {0x81, 0x42, 0x24, 0x18, 0x18, 0x24, 0x42, 0x81};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.RasterPos3f(x, y, z);
  gl.Bitmap(8, 8, 4, 4, 9, 0, kLetter);
}

TEST(TwentyPoints, P01CompileAndExecuteDraws) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE_AND_EXECUTE);
    send(gl, sphere(16, 24));
    gl.EndList();
  });
  EXPECT_EQ(s.trianglesRasterised, 0u);
}

TEST(TwentyPoints, P02DrawingToTheFrontBufferWithoutSwap) {
  expectSame([](Gl gl, Seen& seen) {
    gl.DrawBuffer(GL_FRONT);
    stage(gl);
    send(gl, sphere(16, 24));
    gl.DrawBuffer(GL_NONE);
    sendAt(gl, sphere(8, 12), 0.5f, 0, 1, 0.4f);
    gl.Flush();
    GLint buffer = 0;
    gl.GetIntegerv(GL_DRAW_BUFFER, &buffer);
    seen.push_back(static_cast<float>(buffer));
    gl.DrawBuffer(GL_FRONT);
  });
}

TEST(TwentyPoints, P04DepthIsReadInMidFrame) {
  expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    send(gl, torus(0.8f, 0.4f, 40, 24));
    for (const int x : {70, 100, 120, 150}) {
      GLfloat depth = 0;
      gl.ReadPixels(x, 70, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
      seen.push_back(depth);
    }
    // The point under the cursor becomes the pivot for the following frames.
    gl.Translatef(0, 0, seen.back());
    sendAt(gl, sphere(10, 16), 0, 0, 0, 0.5f);
  });
}

TEST(TwentyPoints, P05DepthClearsAreLayers) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    for (int layer = 0; layer < 5; ++layer) {
      if (layer > 0) gl.Clear(GL_DEPTH_BUFFER_BIT);
      paint(gl, 0.2f * static_cast<float>(layer), 0.6f, 0.9f - 0.2f * static_cast<float>(layer));
      sendAt(gl, sphere(16, 24), -0.8f + 0.4f * static_cast<float>(layer), 0,
             -0.4f * static_cast<float>(layer), 0.5f);
    }
  });
  EXPECT_EQ(s.drawsTraced, 5u);
}

TEST(TwentyPoints, P06ClearsObeyMaskAndScissor) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    send(gl, sphere(16, 24));
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl.ClearColor(0, 0, 0, 0.25f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(40, 30, 90, 50);
    gl.ClearColor(0.3f, 0, 0.3f, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    sendAt(gl, torus(0.7f, 0.2f, 30, 16), 0.1f, -0.1f, 0, 1);
    gl.Disable(GL_SCISSOR_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA);
    paint(gl, 0.1f, 0.9f, 0.3f);
    sendAt(gl, sphere(16, 24), 0.6f, 0.3f, 1, 0.6f);
  });
}

TEST(TwentyPoints, P07FramesWithoutClearUnderAGradient) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    gl.Viewport(0, 0, kWidth, kHeight);
    for (int frame = 0; frame < 3; ++frame) {
      gl.Clear(GL_DEPTH_BUFFER_BIT);
      gl.Disable(GL_DEPTH_TEST), gl.Disable(GL_LIGHTING);
      gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity(), gl.Ortho(0, 1, 0, 1, -1, 1);
      gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
      gl.Begin(GL_QUADS);
      gl.Color3f(0.1f, 0.1f, 0.4f), gl.Vertex2f(0, 0), gl.Vertex2f(1, 0);
      gl.Color3f(0.7f, 0.8f, 1), gl.Vertex2f(1, 1), gl.Vertex2f(0, 1);
      gl.End();
      gl.Enable(GL_DEPTH_TEST);
      camera(gl, kWidth, kHeight);
      keyLight(gl);
      gl.Rotatef(20.0f * static_cast<float>(frame), 0, 1, 0);
      send(gl, torus(0.8f, 0.35f, 30, 20));
    }
  });
  EXPECT_EQ(s.drawsTraced, 3u);
}

TEST(TwentyPoints, P08TextKeepsItsOrder) {
  expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    label(gl, -0.5f, 0.3f, 1.5f);  // before: the sphere covers it
    send(gl, sphere(16, 24));
    gl.PushMatrix();
    gl.Translatef(0.2f, 0, 0);
    gl.Color3f(1, 1, 0);
    gl.Disable(GL_LIGHTING);
    label(gl, 0, 0.2f, 1.2f);  // after, in front: stays
    label(gl, 0, 0, -1.2f);    // after, behind: hidden
    gl.PopMatrix();
    GLfloat position[4];
    gl.GetFloatv(GL_CURRENT_RASTER_POSITION, position);
    seen.assign(position, position + 4);
    const GLuint pixels[] = {0xff0000ffu, 0xff00ff00u, 0xffff0000u, 0xffffffffu};
    gl.Disable(GL_DEPTH_TEST);
    gl.RasterPos3f(0.1f, -0.3f, 1.4f);
    gl.PixelZoom(6, 5);
    gl.DrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHTING);
    sendAt(gl, torus(0.4f, 0.1f, 20, 10), 0, -0.3f, 1.2f, 1);
  });
}

}  // namespace
}  // namespace gluray::test::twenty_points
