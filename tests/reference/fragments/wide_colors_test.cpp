// Floating-point framebuffers.
#include "tests/reference/layers/layer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::test {
namespace {

using Lights = Surface::Lights;

TEST(WideColors, BrighterThanOneStaySo) {
  for (const GLenum format : {GL_RGBA32F, GL_RGBA16F}) {
    std::vector<std::vector<float>> found;
    const auto draw = [&](Gl gl) {
      imageFramebuffer(gl, {imageTexture(gl, format)});
      beginFrame(gl);
      Layer one = seen(ball(24), {2.5f, 0.7f, 0.3f}, 1, placed({0, 0, 0}));
      one.surface.lights = Lights::headlight;
      drawFresh(gl, makeProgram(gl, one.surface), one);
      std::vector<float> colors(size_t{4} * kProgramWidth * kProgramHeight);
      gl.ReadPixels(0, 0, kProgramWidth, kProgramHeight, GL_RGBA, GL_FLOAT, colors.data());
      found.push_back(std::move(colors));
      showInWindow(gl);
    };
    expectSame(format == GL_RGBA32F ? "wide_32" : "wide_16", draw, 1);
    ASSERT_EQ(found.size(), 2u);
    size_t different = 0, bright = 0;
    for (size_t i = 0; i < found[0].size(); ++i) {
      different += std::abs(found[0][i] - found[1][i]) > 4e-3f;
      bright += found[0][i] > 1.5f;
    }
    EXPECT_LT(static_cast<double>(different), 0.002 * static_cast<double>(found[0].size()));
    EXPECT_GT(bright, 1000u);
  }
}

TEST(WideColors, OfWhatTheRealOneDrawsAgain) {
  const auto draw = [](Gl gl) {
    imageFramebuffer(gl, {imageTexture(gl, GL_RGBA32F)});
    beginFrame(gl);
    const Layer one = seen(ball(24), {2.5f, 0.7f, 0.3f}, 1, placed({0, 0, 0}));
    drawFresh(gl, makeProgram(gl, one.surface), one);
    showInWindow(gl);
  };
  expectSameWhenTracingFails("wide_again", draw);
}

TEST(WideColors, OfFixedFunctionAreDrawnByTheRealOne) {
  const auto draw = [](Gl gl) {
    imageFramebuffer(gl, {imageTexture(gl, GL_RGBA32F)});
    beginFrame(gl);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(2, 0.5f, 0.25f);
    gl.Vertex3f(-0.5f, -0.5f, 0), gl.Vertex3f(0.5f, -0.5f, 0.1f), gl.Vertex3f(0, 0.5f, 0.2f);
    gl.End();
    showInWindow(gl);
  };
  ContextWish wish{kProgramWidth, kProgramHeight};
  expectSame("wide_fixed", draw, 0, wish);
}

}  // namespace
}  // namespace gluray::test
