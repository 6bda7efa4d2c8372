// State that is read back with one group and changed by another group's call: the image must follow.
#include "scenes/texels.h"
#include "tests/reference/framebuffer.h"
#include "tests/reference/hostile/habits.h"

#include <thread>

namespace gluray::test::twenty_points {
namespace {

TEST(StaleState, FogGroupOfTheAttributeStackHoldsColourSum) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Disable(GL_LIGHTING);
    gl.Color3f(0.2f, 0.5f, 0.1f);
    gl.SecondaryColor3f(0.5f, 0, 0.5f);
    gl.PushAttrib(GL_FOG_BIT);
    gl.Enable(GL_COLOR_SUM);
    sendAt(gl, sphere(12, 16), -0.7f, 0, 0, 0.6f);
    gl.PopAttrib();
    sendAt(gl, sphere(12, 16), 0.7f, 0, 0, 0.6f);
  });
}

TEST(StaleState, TransformGroupOfTheAttributeStackHoldsDepthClamp) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Enable(GL_DEPTH_CLAMP);
    gl.PushAttrib(GL_TRANSFORM_BIT);
    gl.Disable(GL_DEPTH_CLAMP);
    sendAt(gl, sphere(12, 16), -0.7f, 0, 0, 0.4f);
    gl.PopAttrib();
    sendAt(gl, sphere(12, 16), 0.7f, 0.8f, 2.9f, 0.8f);  // through the near plane
  });
}

TEST(StaleState, FlatShadingByTheFirstVertex) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Disable(GL_LIGHTING);
    gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    sendAt(gl, sphere(8, 12), -0.7f, 0, 0, 0.6f, kColors);
    gl.ShadeModel(GL_FLAT);
    sendAt(gl, sphere(8, 12), 0.7f, 0, 0, 0.6f, kColors);
    gl.ShadeModel(GL_SMOOTH);
    sendAt(gl, sphere(8, 12), 0, 0.8f, 0, 0.3f, kColors);
  });
}

/// Two strips in one draw, separated by primitive restart, after a draw without it.
void restartedStrips(Gl gl, GLenum capability, GLubyte restart) {
  stage(gl);
  gl.Disable(GL_LIGHTING);
  std::vector<float> positions(256 * 3);
  for (size_t i = 0; i < 256; ++i) {
    positions[3 * i] = static_cast<float>(i / 2) * 0.3f - 1.2f;
    positions[3 * i + 1] = i % 2 ? 0.5f : -0.5f;
    positions[3 * i + 2] = 0.02f * static_cast<float>(i);
  }
  const GLubyte whole[] = {0, 1, 2, 3}, parted[] = {4, 5, 6, 7, restart, 10, 11, 12, 13};
  gl.PrimitiveRestartIndex(restart);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
  gl.Color3f(1, 0, 0);
  gl.DrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, whole);
  gl.Enable(capability);
  gl.Color3f(0, 1, 0);
  gl.DrawElements(GL_TRIANGLE_STRIP, 9, GL_UNSIGNED_BYTE, parted);
  gl.Disable(capability);
  gl.Color3f(0, 0, 1);
  gl.Translatef(0, -0.9f, 0);
  gl.DrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, whole);
}

TEST(StaleState, PrimitiveRestartIsSwitched) {
  expectSame([](Gl gl, Seen&) { restartedStrips(gl, GL_PRIMITIVE_RESTART, 100); });
}

TEST(StaleState, PrimitiveRestartByTheHighestIndex) {
  expectSame([](Gl gl, Seen&) { restartedStrips(gl, GL_PRIMITIVE_RESTART_FIXED_INDEX, 255); });
}

/// Opaque texels with a translucent border, which samples beyond the texels blend with.
TEST(StaleState, TranslucentBorderOfAnOpaqueTexture) {
  for (const GLint wrap : {GL_CLAMP_TO_BORDER, GL_CLAMP})
    expectSame(
        [wrap](Gl gl, Seen&) {
          stage(gl);
          send(gl, sphere(12, 16));
          gl.Disable(GL_LIGHTING);
          gl.Color3f(1, 1, 1);
          gl.Enable(GL_BLEND);
          gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
          gl.Enable(GL_TEXTURE_2D);
          const std::vector<uint32_t> texels(4 * 4, 0xFF40A0F0);
          gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
          sampling(gl, GL_TEXTURE_2D, GL_LINEAR, wrap);
          const Color border{0.2f, 0, 0.9f, 0.3f};
          gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border.data());
          gl.Translatef(0, 0, 1.1f);
          gl.Rotatef(30, 0, 1, 0);
          scenes::quad(gl, 0, 0, 0.9f, -0.5f, 1.5f);
        },
        {kTexelEdges});
}

/// A texture drawn into by calls that name its framebuffer instead of binding it.
void drawPointsInto(Gl gl, GLuint framebuffer, bool blit) {
  const Color green{0, 1, 0, 1};
  if (!blit) return gl.ClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, green.data());
  gl.BlitNamedFramebuffer(0, framebuffer, 0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

TEST(StaleState, TexturesOfNamedFramebuffers) {
  for (const bool blit : {false, true})
    expectSame([blit](Gl gl, Seen&) {
      stage(gl);
      gl.Disable(GL_LIGHTING);
      gl.Color3f(1, 1, 1);
      gl.Enable(GL_TEXTURE_2D);
      const GLuint texture = bindFresh(gl, GL_TEXTURE_2D);
      scenes::upload(gl, GL_RGBA8, 8, GL_NEAREST, GL_REPEAT);
      GLuint framebuffer = 0;
      gl.GenFramebuffers(1, &framebuffer);
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
      gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
      sendAt(gl, sphere(12, 16), -0.7f, 0, 0, 0.6f, kTexcoords);
      drawPointsInto(gl, framebuffer, blit);
      sendAt(gl, sphere(12, 16), 0.7f, 0, 0, 0.6f, kTexcoords);
    });
}

/// Corners of a triangle, as the colours of three pixels.
void clearCorners(Gl gl, float z) {
  gl.Enable(GL_SCISSOR_TEST);
  const float corners[3][3] = {{0, 0, z}, {1, 0, 0.5f}, {0, 1, 0.25f}};
  for (int i = 0; i < 3; ++i) {
    gl.Scissor(i, 0, 1, 1);
    gl.ClearColor(corners[i][0], corners[i][1], corners[i][2], 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  gl.Disable(GL_SCISSOR_TEST);
}

TEST(StaleState, PixelsReadIntoAVertexBuffer) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Disable(GL_LIGHTING);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    gl.BufferData(GL_PIXEL_PACK_BUFFER, 9 * sizeof(float), nullptr, GL_DYNAMIC_COPY);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    for (const float z : {0.0f, 1.0f}) {
      clearCorners(gl, z);
      gl.ReadPixels(0, 0, 3, 1, GL_RGB, GL_FLOAT, nullptr);
      gl.Color3f(1, z, 0);
      gl.Translatef(-0.4f, 0, 0);
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  });
}

/// The middle of the image after a textured sphere was drawn.
uint32_t middleOfSphere(TracedContext& context, GLuint texture) {
  const gl::RealGl& gl = context.gl();
  stage(gl);
  gl.Disable(GL_LIGHTING);
  gl.Color3f(1, 1, 1);
  gl.Enable(GL_TEXTURE_2D);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  send(gl, sphere(12, 16), kTexcoords);
  return context.read().colors[kHeight / 2 * kWidth + kWidth / 2];
}

TEST(StaleState, AnotherThreadsContextChangesASharedTexture) {
  TracedContext first({kWidth, kHeight});
  constexpr uint32_t kRed = 0xFF0000FF, kGreen = 0xFF00FF00;
  const GLuint texture = bindFresh(first.gl(), GL_TEXTURE_2D);
  first.gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &kRed);
  sampling(first.gl(), GL_TEXTURE_2D, GL_NEAREST, GL_REPEAT);
  EXPECT_EQ(middleOfSphere(first, texture), kRed);
  std::thread([&] {
    TracedContext second({kWidth, kHeight}, TracedContext::vertexShading(), nullptr, &first);
    second.gl().BindTexture(GL_TEXTURE_2D, texture);
    second.gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kGreen);
    second.gl().Finish();
  }).join();
  EXPECT_EQ(middleOfSphere(first, texture), kGreen);
  EXPECT_GE(first.context().counts.statistics.drawsTraced, 2u);
}

/// Other APIs may read the images of a framebuffer object, as CUDA does.
TEST(StaleState, FinishDrawsIntoFramebufferObjects) {
  const TracedContext ours({kWidth, kHeight});
  const gl::RealGl& gl = ours.gl();
  bindNewFramebuffer(gl, {kWidth, kHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24);
  stage(gl);
  send(gl, sphere(12, 16));
  gl.PushMatrix(), gl.PopMatrix();  // the run ends
  EXPECT_FALSE(ours.context().pending.batch.empty());
  const uint64_t frames = ours.context().counts.statistics.frames;
  gl.Finish();
  EXPECT_TRUE(ours.context().pending.batch.empty());
  EXPECT_EQ(ours.context().counts.statistics.frames, frames) << "the window's frame goes on";
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 1u);
}

/// Another thread may swap buffers, or read them, once glFinish has returned.
TEST(StaleState, FinishDrawsIntoTheWindowWhereThreadsShareIt) {
  TracedContext ours({kWidth, kHeight});
  std::thread([] { const TracedContext other({kWidth, kHeight}); }).join();
  EXPECT_TRUE(gl::usedByThreads());
  ours.setDoubleBuffered(true);
  const gl::RealGl& gl = ours.gl();
  gl.DrawBuffer(GL_BACK);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  stage(gl);
  send(gl, sphere(12, 16));
  gl.Finish();
  EXPECT_TRUE(ours.context().pending.batch.empty());
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 1u);
}

}  // namespace
}  // namespace gluray::test::twenty_points
