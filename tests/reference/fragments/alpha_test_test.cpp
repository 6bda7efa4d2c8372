// The alpha test compares in the framebuffer's precision (GL 2.1, 4.1.4).
#include "tests/reference/both.h"
#include "tests/reference/framebuffer.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace gluray::test {
namespace {

using scenes::Gl;

constexpr int kAlphaTestWidth = 120, kAlphaTestHeight = 90;
constexpr GLenum kFunctions[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                 GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
constexpr float kReference = 0.4f;  // 102 of 255

void prepare(Gl gl) {
  gl.Viewport(0, 0, kAlphaTestWidth, kAlphaTestHeight);
  gl.ClearColor(0.2f, 0.3f, 0.5f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_ALPHA_TEST);
}

/// Triangles one below the other; their alphas differ by less than an eight-bit step.
void drawAlphas(Gl gl) {
  constexpr std::array<float, 6> kAlphas = {0.3978f, 0.3986f, 0.3999f, 0.4015f, 0.4025f, 0.404f};
  gl.Begin(GL_TRIANGLES);
  for (size_t i = 0; i < kAlphas.size(); ++i) {
    const float y = -0.9f + 0.3f * static_cast<float>(i);
    gl.Color4f(1, 0.15f * static_cast<float>(i), 0.1f, kAlphas[i]);
    gl.Vertex3f(-0.9f, y, 0.3f), gl.Vertex3f(0.9f, y, 0.1f), gl.Vertex3f(0, y + 0.27f, 0.2f);
  }
  gl.End();
}

TEST(AlphaTest, ComparesInThePrecisionOfTheFramebuffer) {
  for (const GLenum format : {GLenum{0}, GLenum{GL_RGBA8}, GLenum{GL_RGB10_A2}}) {
    for (const GLenum function : kFunctions) {
      const BothStage stage{.width = kAlphaTestWidth,
                            .height = kAlphaTestHeight,
                            .folder = "alpha_test",
                            .prepare = prepare,
                            .tolerance = {1, 0, 1e-6f, "the same fragments pass"}};
      const std::string name = std::to_string(format) + '_' + std::to_string(function - GL_NEVER);
      const gl::Statistics seen = compareBoth(stage, name, [&](Gl gl) {
        if (format) {
          bindNewFramebuffer(gl, {kAlphaTestWidth, kAlphaTestHeight}, format, GL_DEPTH_COMPONENT24);
          prepare(gl);
        }
        gl.AlphaFunc(function, kReference);
        drawAlphas(gl);
      });
      EXPECT_EQ(seen.drawsTraced, 1u) << name;
    }
  }
}

}  // namespace
}  // namespace gluray::test
