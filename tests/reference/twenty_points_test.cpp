// Twenty habits of real programs that break a naive interceptor, each drawn by the real OpenGL and through
// ours: the same picture, the same answers. Those that need a window are in tests/doors.
#include "scenes/stage.h"
#include "tests/reference/traced_context.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace gluray::test {
namespace {

using namespace scenes;

constexpr int kWidth = 240, kHeight = 180;

/// What the program read back on its way.
using Seen = std::vector<float>;
using Program = std::function<void(Gl, Seen&)>;

struct Run {
  Picture picture;
  Seen seen;
  GLenum error = GL_NO_ERROR;
};

struct Expected {
  Tolerance tolerance = {};
  float seenTolerance = 1e-4f;
  uint64_t traced = 1;  // draws, at least
};

Run runWith(Gl gl, const Program& program) {
  Run run;
  program(gl, run.seen);
  run.picture = readPicture(gl, kWidth, kHeight);
  run.error = gl.GetError();
  return run;
}

/// Runs the program both ways and compares; what was counted.
gl::Statistics expectSame(const Program& program, const Expected& wanted = {}) {
  const auto real = OsmesaContext::create({kWidth, kHeight});
  const Run expected = runWith(real->real(), program);
  TracedContext ours({kWidth, kHeight});
  const Run got = runWith(ours.gl(), program);
  const Comparison c = compare(expected.picture, got.picture, wanted.tolerance);
  EXPECT_TRUE(c.accepted) << c.text;
  if (!c.accepted)
    writeFailure(TEST_OUTPUT, testing::UnitTest::GetInstance()->current_test_info()->name(), expected.picture,
                 got.picture);
  EXPECT_EQ(expected.error, got.error);
  EXPECT_EQ(expected.seen.size(), got.seen.size());
  for (size_t i = 0; i < std::min(expected.seen.size(), got.seen.size()); ++i)
    EXPECT_NEAR(expected.seen[i], got.seen[i], wanted.seenTolerance) << "answer " << i;
  EXPECT_FALSE(ours.context().passthrough()) << "the context stepped aside";
  EXPECT_GE(ours.context().statistics.drawsTraced, wanted.traced);
  return ours.context().statistics;
}

void stage(Gl gl) {
  scenes::begin(gl, kWidth, kHeight);
  camera(gl, kWidth, kHeight);
  keyLight(gl);
  paint(gl, 0.8f, 0.5f, 0.3f);
}

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
    // What is under the cursor becomes the pivot of what follows.
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

TEST(TwentyPoints, P09SeveralCamerasViewportsAndDepthRanges) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.DepthRange(0.1, 1);
    send(gl, sphere(16, 24));
    gl.Viewport(0, 0, 60, 60);  // axis cross
    gl.DepthRange(0, 0.1);
    flatCamera(gl, 60, 60, 1.2);
    gl.Rotatef(35, 1, 1, 0);
    sendAt(gl, vase(16, 12), 0, 0, 0, 0.8f);
    gl.Viewport(kWidth - 50, kHeight - 50, 50, 50);  // navigation cube
    gl.DepthRange(0.05, 0.5);
    camera(gl, 50, 50, 3);
    send(gl, torus(0.7f, 0.3f, 20, 12));
  });
  EXPECT_EQ(s.drawsTraced, 3u);
}

TEST(TwentyPoints, P10FlushAndFinishMeanNothing) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    const GLuint canvas = [&] {  // a framebuffer that nobody sees
      GLuint names[3];
      gl.GenFramebuffers(1, names);
      gl.GenRenderbuffers(2, names + 1);
      gl.BindFramebuffer(GL_FRAMEBUFFER, names[0]);
      const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24},
                   places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
      for (int i = 0; i < 2; ++i) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, names[i + 1]);
        gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], kWidth, kHeight);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, names[i + 1]);
      }
      return names[0];
    }();
    stage(gl);
    const Model m = sphere(8, 12);
    for (int i = 0; i < 60; ++i) {
      sendAt(gl, m, -1.2f + 0.04f * static_cast<float>(i), 0, 0, 0.2f);
      i % 2 ? gl.Flush() : gl.Finish();
    }
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, canvas);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight,
                       GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
  EXPECT_EQ(s.drawsTraced, 60u);
  EXPECT_LE(s.flushes, 2u) << "every glFlush was taken for the end of a frame";
}

TEST(TwentyPoints, P11SelectionAndFeedbackComeFromTheRealOne) {
  const gl::Statistics s = expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    const auto draw = [&] {
      gl.InitNames();
      gl.PushName(0);
      for (GLuint name = 1; name <= 4; ++name) {
        gl.LoadName(name);
        sendAt(gl, sphere(8, 12), -1.2f + 0.6f * static_cast<float>(name), 0, 0.3f * static_cast<float>(name),
               0.3f);
      }
    };
    draw();
    std::array<GLuint, 64> hits{};
    gl.SelectBuffer(static_cast<GLsizei>(hits.size()), hits.data());
    gl.RenderMode(GL_SELECT);
    draw();
    const GLint count = gl.RenderMode(GL_RENDER);
    seen.push_back(static_cast<float>(count));
    for (int i = 0; i < count; ++i) {
      seen.push_back(static_cast<float>(hits[static_cast<size_t>(4 * i)]));      // names of the hit
      seen.push_back(static_cast<float>(hits[static_cast<size_t>(4 * i + 3)]));  // the name
    }
    std::vector<GLfloat> feedback(20000);
    gl.FeedbackBuffer(static_cast<GLsizei>(feedback.size()), GL_3D, feedback.data());
    gl.RenderMode(GL_FEEDBACK);
    draw();
    seen.push_back(static_cast<float>(gl.RenderMode(GL_RENDER)));
    seen.insert(seen.end(), feedback.begin(), feedback.begin() + 100);
    sendAt(gl, torus(0.5f, 0.2f, 16, 8), 0, 0.6f, 0, 1);
  });
  EXPECT_EQ(s.drawsTraced, 5u);
}

TEST(TwentyPoints, P12MaterialsPerVertexAndSidesThatToggle) {
  expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    const Model m = sheet(10);
    for (int pass = 0; pass < 12; ++pass) {
      gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, pass % 2);
      gl.PushMatrix();
      gl.Translatef(-1.1f + 0.2f * static_cast<float>(pass), 0.1f * static_cast<float>(pass % 3), 0);
      gl.Rotatef(30.0f * static_cast<float>(pass), 0, 1, 0);
      gl.Scalef(0.25f, 0.4f, 0.3f);
      gl.Begin(GL_TRIANGLES);
      for (size_t i = 0; i < m.indices.size(); ++i) {
        const uint32_t v = m.indices[i];
        const float t = static_cast<float>(i % 7) / 7;
        // Of both faces: Mesa 22.3 lights backs with green and blue of the front where materials change
        // inside glBegin.
        const GLfloat color[] = {t, 1 - t, 0.3f, 1};
        gl.Materialfv(GL_FRONT_AND_BACK, i % 2 ? GL_DIFFUSE : GL_AMBIENT_AND_DIFFUSE, color);
        gl.Normal3fv(&m.normals[3 * v]);
        gl.Vertex3fv(&m.positions[3 * v]);
      }
      gl.End();
      gl.PopMatrix();
    }
    GLfloat left[4];
    gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, left);
    seen.assign(left, left + 4);
    for (const GLenum mode : {GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_EMISSION, GL_SPECULAR}) {
      gl.ColorMaterial(GL_FRONT_AND_BACK, mode);
      gl.Enable(GL_COLOR_MATERIAL);
      sendAt(gl, sphere(8, 12), -0.9f + 0.001f * static_cast<float>(mode - GL_AMBIENT), 0.8f, 0, 0.2f,
             kNormals | kColors);
      gl.Disable(GL_COLOR_MATERIAL);
    }
  });
}

TEST(TwentyPoints, P13PointersLatchTheirBufferAndListsReadAtOnce) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Enable(GL_NORMALIZE);
    const Model m = sphere(10, 16);
    std::vector<GLdouble> positions(m.positions.begin(), m.positions.end());
    std::vector<GLbyte> normals;
    std::vector<GLubyte> colors;
    std::vector<GLushort> indices(m.indices.begin(), m.indices.end());
    for (size_t v = 0; v < m.vertexCount(); ++v) {
      for (size_t c = 0; c < 3; ++c) normals.push_back(static_cast<GLbyte>(127 * m.normals[3 * v + c]));
      normals.push_back(0);  // stride 4
      for (const int shift : {5, 3, 1}) colors.push_back(static_cast<GLubyte>(v << shift & 255));
    }
    GLuint buffers[2];
    gl.GenBuffers(2, buffers);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(GLdouble)),
                  positions.data(), GL_STATIC_DRAW);
    gl.VertexPointer(3, GL_DOUBLE, 0, nullptr);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[1]);  // the pointer keeps the first
    gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.NormalPointer(GL_BYTE, 4, normals.data());
    gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, colors.data());
    gl.Enable(GL_COLOR_MATERIAL);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY}) gl.EnableClientState(array);
    const auto draw = [&] {
      gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
    };
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    draw();
    gl.EndList();
    for (GLubyte& c : colors) c = static_cast<GLubyte>(255 - c);
    std::fill(indices.begin(), indices.end(), GLushort{0});  // the list has read them already
    gl.CallList(list);
    indices.assign(m.indices.begin(), m.indices.end());
    gl.Translatef(0.9f, 0, 0.5f), gl.Scalef(0.5f, 0.5f, 0.5f);
    draw();
  });
  EXPECT_EQ(s.trianglesRasterised, 0u);
}

TEST(TwentyPoints, P13ArraysRewrittenBetweenDrawsOfOneList) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Enable(GL_NORMALIZE);
    std::array<GLfloat, 14 * 10> tube;  // position, normal, colour: stride 40, as one program has it
    gl.InterleavedArrays(GL_V3F, 40, tube.data());
    gl.EnableClientState(GL_NORMAL_ARRAY), gl.NormalPointer(GL_FLOAT, 40, tube.data() + 3);
    gl.EnableClientState(GL_COLOR_ARRAY), gl.ColorPointer(4, GL_FLOAT, 40, tube.data() + 6);
    gl.Enable(GL_COLOR_MATERIAL);
    GLuint order[14];
    for (GLuint i = 0; i < 14; ++i) order[i] = i;
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    for (int segment = 0; segment < 60; ++segment) {
      for (int i = 0; i < 14; ++i) {
        const float along = static_cast<float>(segment + i % 2) * 0.1f,
                    around = 1.0472f * static_cast<float>(i / 2);
        const float values[] = {std::cos(along) + 0.1f * std::cos(around) * std::cos(along),
                                -0.8f + 0.27f * along + 0.1f * std::sin(around),
                                std::sin(along) + 0.1f * std::cos(around) * std::sin(along),
                                std::cos(around) * std::cos(along),
                                std::sin(around),
                                std::cos(around) * std::sin(along),
                                0.5f + 0.5f * std::sin(along),
                                0.4f,
                                0.8f,
                                1};
        std::copy(std::begin(values), std::end(values), tube.begin() + 10 * i);
      }
      gl.DrawElements(GL_TRIANGLE_STRIP, 14, GL_UNSIGNED_INT, order);
    }
    gl.EndList();
    tube.fill(0);
    gl.CallList(list);
  });
}

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

TEST(TwentyPoints, P16TransparencyOverTheTracedPicture) {
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
  EXPECT_EQ(s.drawsTraced, 3u);
}

TEST(TwentyPoints, P17CoplanarLinesWin) {
  expectSame(
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
  Picture first;
  uint64_t builds = 0, meshes = 0;
  for (int frame = 0; frame < 20; ++frame) {
    stage(ours.gl());
    send(ours.gl(), m);
    const Picture now = ours.read();
    const gl::Statistics& s = ours.context().statistics;
    if (frame == 0) first = now, builds = s.blasBuilds, meshes = s.meshesBuilt;
    EXPECT_TRUE(now == first) << "frame " << frame;
    EXPECT_EQ(s.blasBuilds, builds);
    EXPECT_EQ(s.meshesBuilt, meshes) << "an unchanged run was not recognised in frame " << frame;
  }
}

}  // namespace
}  // namespace gluray::test
