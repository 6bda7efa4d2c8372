// Limits of the capture: evaluators inside glBegin, textures changed by drawing, framebuffers.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kCapturedSize = 64;

/// A Bezier patch as strips of evaluated points, the first row of each sent as plain vertices.
DrawnImage evaluated(Gl gl) {
  static const GLfloat points[4][3] = {
      {-0.8f, -0.8f, 0}, {0.8f, -0.8f, 0.3f}, {-0.8f, 0.8f, -0.3f}, {0.8f, 0.8f, 0}};
  gl.Enable(GL_DEPTH_TEST), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, &points[0][0]);
  gl.Enable(GL_MAP2_VERTEX_3);
  for (int row = 0; row < 4; ++row) {
    gl.Color3f(0.25f * static_cast<float>(row), 0.5f, 0.75f);
    gl.Begin(GL_TRIANGLE_STRIP);
    gl.Vertex3f(-0.9f, -0.8f + 0.4f * static_cast<float>(row), 0.1f);
    for (int i = 0; i <= 4; ++i)
      for (int k = 0; k < 2; ++k)
        gl.EvalCoord2f(0.25f * static_cast<float>(i), 0.25f * static_cast<float>(row + k));
    gl.End();
  }
  gl.Begin(GL_TRIANGLES), gl.Color3f(1, 1, 0);  // capture must work again afterwards
  gl.Vertex3f(-0.2f, -0.2f, -0.9f), gl.Vertex3f(0.2f, -0.2f, -0.8f), gl.Vertex3f(0, 0.2f, -0.9f);
  gl.End();
  return readImage(gl, kCapturedSize, kCapturedSize);
}

TEST(CaptureLimits, EvaluatorsInsideBeginAreTheRealOnes) {
  const auto real = OsmesaContext::create({kCapturedSize, kCapturedSize});
  TracedContext ours({kCapturedSize, kCapturedSize});
  const DrawnImage expected = evaluated(real->real()), got = evaluated(ours.gl());
  size_t different = 0;
  for (size_t i = 0; i < got.colors.size(); ++i) different += got.colors[i] != expected.colors[i];
  EXPECT_LE(different, got.colors.size() / 100) << "the traced triangle's edge";
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 1u) << "the triangle without evaluators";
}

/// Twice, in two colours: draws into a framebuffer object, then a quad textured with the result.
std::vector<uint32_t> texturedByDrawing(Gl gl) {
  GLuint texture = 0, framebuffer = 0;
  gl.GenTextures(1, &texture), gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST),
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  std::vector<uint32_t> pixels;
  for (const float red : {1.0f, 0.0f}) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.ClearColor(red, 0.2f, 0.6f, 1), gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.ClearColor(0, 0, 0, 1), gl.Enable(GL_DEPTH_TEST), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_TEXTURE_2D);
    gl.Begin(GL_TRIANGLES), gl.Vertex3f(-0.9f, -0.9f, 0.2f), gl.Vertex3f(0.9f, -0.9f, 0),
        gl.Vertex3f(0, 0.9f, 0.1f), gl.End();
    gl.Disable(GL_TEXTURE_2D);
    uint32_t pixel = 0;
    gl.ReadPixels(kCapturedSize / 2, kCapturedSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    pixels.push_back(pixel);
  }
  return pixels;
}

TEST(CaptureLimits, TextureThatWasDrawnIsReadAgain) {
  const auto real = OsmesaContext::create({kCapturedSize, kCapturedSize});
  TracedContext ours({kCapturedSize, kCapturedSize});
  EXPECT_EQ(texturedByDrawing(ours.gl()), texturedByDrawing(real->real()));
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 2u);
}

void triangleAt(Gl gl, float x) {
  gl.Begin(GL_TRIANGLES), gl.Vertex3f(x, -0.5f, 0.2f), gl.Vertex3f(x + 0.4f, -0.5f, 0),
      gl.Vertex3f(x, 0.5f, 0.1f), gl.End();
}

/// Two triangles into a framebuffer object with depth, `between` after the first; then reads another one.
DrawnImage inObject(Gl gl, void (*between)(Gl, GLuint)) {
  GLuint objects[2], buffers[4];
  gl.GenFramebuffers(2, objects), gl.GenRenderbuffers(4, buffers);
  for (int i = 0; i < 2; ++i) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, objects[i]);
    for (int k = 0; k < 2; ++k) {
      gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[2 * i + k]);
      gl.RenderbufferStorage(GL_RENDERBUFFER, k ? GL_DEPTH_COMPONENT24 : GL_RGBA8, kCapturedSize,
                             kCapturedSize);
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, k ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                                 GL_RENDERBUFFER, buffers[2 * i + k]);
    }
    gl.Enable(GL_DEPTH_TEST), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  triangleAt(gl, -0.9f);
  between(gl, objects[1]);
  triangleAt(gl, 0.3f);
  return readImage(gl, kCapturedSize, kCapturedSize);
}

TEST(CaptureLimits, OnlyAnotherFramebufferEndsABatch) {
  const struct {
    void (*between)(Gl, GLuint);
    uint64_t flushes;
  } cases[] = {
      {[](Gl gl, GLuint bound) { gl.BindFramebuffer(GL_FRAMEBUFFER, bound); }, 1},
      {[](Gl gl, GLuint bound) { gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, bound); }, 1},
      {[](Gl gl, GLuint bound) {
         gl.BindFramebuffer(GL_FRAMEBUFFER, 0), gl.BindFramebuffer(GL_FRAMEBUFFER, bound);
       },
       2},
      {[](Gl gl, GLuint bound) {
         gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0), gl.BindFramebuffer(GL_FRAMEBUFFER, bound);
       },
       2},
  };
  for (const auto& c : cases) {
    const auto real = OsmesaContext::create({kCapturedSize, kCapturedSize});
    TracedContext ours({kCapturedSize, kCapturedSize});
    const DrawnImage expected = inObject(real->real(), c.between), got = inObject(ours.gl(), c.between);
    size_t different = 0;
    for (size_t i = 0; i < got.colors.size(); ++i) different += got.colors[i] != expected.colors[i];
    EXPECT_LE(different, got.colors.size() / 100) << &c - cases;
    EXPECT_EQ(ours.context().counts.statistics.flushes, c.flushes) << &c - cases;
  }
}

TEST(CaptureLimits, UnusualSamplingIsRasterised) {
  void (*const forms[])(Gl) = {
      [](Gl gl) { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_GREEN); },
      [](Gl gl) {
        const float depth = 0.5f;
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
      },
      [](Gl gl) {
        GLuint sampler = 0;
        gl.GenSamplers(1, &sampler), gl.BindSampler(0, sampler);
        gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.SamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
      },
  };
  for (const auto form : forms) {
    TracedContext ours({kCapturedSize, kCapturedSize});
    Gl gl = ours.gl();
    const uint32_t texel = 0xFF204080u;
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    form(gl);
    gl.Enable(GL_TEXTURE_2D), gl.Enable(GL_DEPTH_TEST), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Begin(GL_TRIANGLES), gl.Vertex3f(-0.9f, -0.9f, 0.2f), gl.Vertex3f(0.9f, -0.9f, 0),
        gl.Vertex3f(0, 0.9f, 0.1f), gl.End();
    gl.Finish();
    EXPECT_EQ(
        ours.context().counts.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::textureFormat)],
        1u)
        << &form - forms;
  }
}

}  // namespace
}  // namespace gluray::test
