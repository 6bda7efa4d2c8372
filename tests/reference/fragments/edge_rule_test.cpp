// Which triangle owns a sample exactly on its edge: OpenGL leaves the choice to implementations, but
// exactly one of two neighbours owns it, and programs that draw rectangles to the pixel see which sides.
#include "tests/reference/both.h"
#include "tests/reference/framebuffer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {
namespace {

using scenes::Gl;

constexpr int kEdgesWidth = 120, kEdgesHeight = 90;
constexpr scenes::Tolerance kSameCoverage{1, 0, 1e-6f, "the same samples are covered"};

/// Window positions are vertices.
void beginPixels(Gl gl) {
  gl.Viewport(0, 0, kEdgesWidth, kEdgesHeight);
  gl.ClearColor(0.1f, 0.2f, 0.4f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity();
  gl.Ortho(0, kEdgesWidth, 0, kEdgesHeight, -1, 1);
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
}

/// Tilted: flat layers are left to the real OpenGL.
void rectangle(Gl gl, glm::vec2 lower, glm::vec2 size, float depth = 0, float tilt = 0.01f) {
  const glm::vec2 upper = lower + size;
  const float tilted = depth + tilt;
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(lower.x, lower.y, depth), gl.Vertex3f(upper.x, lower.y, depth);
  gl.Vertex3f(upper.x, upper.y, tilted), gl.Vertex3f(lower.x, lower.y, depth);
  gl.Vertex3f(upper.x, upper.y, tilted), gl.Vertex3f(lower.x, upper.y, tilted);
  gl.End();
}

/// Rectangles whose sides are `offset` from the corners of pixels, in both directions.
void rectangles(Gl gl, glm::vec2 offset) {
  beginPixels(gl);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 8; ++column) {
      gl.Color3f(1, 0.125f * static_cast<float>(column), 0.16f * static_cast<float>(row));
      rectangle(gl, glm::vec2(15 * column, 15 * row) + offset, {column + 2, row + 3},
                0.02f * static_cast<float>(row * 8 + column) - 0.5f);
    }
}

/// Triangles with corners at the middles of pixels, whose edges pass many others.
void slanted(Gl gl) {
  beginPixels(gl);
  constexpr glm::vec2 kEnds[] = {{8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {-4, 8}, {-8, 8}, {-8, 4}};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 6; ++column) {
      const glm::vec2 middle(10.5f + 20.0f * static_cast<float>(column),
                             10.5f + 20.0f * static_cast<float>(row));
      const glm::vec2 a = kEnds[(row * 6 + column) % 8], b = kEnds[(row * 6 + column + 1 + row) % 8];
      gl.Color3f(0.2f, 1, 0.15f * static_cast<float>(column));
      gl.Begin(GL_TRIANGLES);
      float depth = 0;
      for (const glm::vec2 at : {middle, middle + a, middle + b}) gl.Vertex3f(at.x, at.y, depth += 0.01f);
      gl.End();
    }
}

BothStage edgeStage() {
  return {.width = kEdgesWidth,
          .height = kEdgesHeight,
          .folder = "edge_rule",
          .prepare = [](Gl) {},
          .tolerance = kSameCoverage};
}

TEST(EdgeRule, SidesOfRectanglesThroughMiddlesOfPixels) {
  for (const glm::vec2 offset : {glm::vec2(0.5f, 0.5f), {0.5f, 0.2f}, {0.7f, 0.5f}, {0, 0}}) {
    const gl::Statistics s = compareBoth(edgeStage(), "rectangles", [&](Gl gl) { rectangles(gl, offset); });
    EXPECT_GT(s.drawsTraced, 0u);
    EXPECT_EQ(s.drawsRasterised, 0u);
  }
}

TEST(EdgeRule, SlantedEdgesThroughMiddlesOfPixels) {
  EXPECT_GT(compareBoth(edgeStage(), "slanted", slanted).drawsTraced, 0u);
}

/// In framebuffer objects y counts from the other side of memory.
TEST(EdgeRule, FramebufferObjectsHaveTheSameRule) {
  for (const GLsizei samples : {0, 4}) {
    for (const float offset : {0.5f, 0.125f, 0.375f, 0.625f, 0.875f}) {
      const auto draw = [&](Gl gl) {
        bindNewFramebuffer(gl, {kEdgesWidth, kEdgesHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24, samples);
        rectangles(gl, glm::vec2(offset));
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        gl.BlitFramebuffer(0, 0, kEdgesWidth, kEdgesHeight, 0, 0, kEdgesWidth, kEdgesHeight,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
      };
      EXPECT_GT(compareBoth(edgeStage(), "framebuffer-" + std::to_string(samples), draw).drawsTraced, 0u);
    }
  }
}

/// The same rectangles through a perspective, facing the viewer: their corners are rounded on the way.
TEST(EdgeRule, FacingTheViewerInPerspective) {
  const auto draw = [](Gl gl) {
    rectangles(gl, {0.5f, 0.5f});
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.MatrixMode(GL_PROJECTION);
    constexpr float kFar = 7, kHalfX = kEdgesWidth / 2.0f / kFar, kHalfY = kEdgesHeight / 2.0f / kFar;
    gl.LoadMatrixf(glm::value_ptr(glm::frustum(-kHalfX, kHalfX, -kHalfY, kHalfY, 1.0f, 20.0f)));
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadMatrixf(
        glm::value_ptr(glm::translate(glm::mat4(1), {-kEdgesWidth / 2.0f, -kEdgesHeight / 2.0f, -kFar})));
    for (int i = 0; i < 6; ++i)
      rectangle(gl, {4.5f + 19.0f * static_cast<float>(i), 7.5f}, {11, 60}, 0, 1e-6f);
  };
  EXPECT_GT(compareBoth(edgeStage(), "perspective", draw).drawsTraced, 0u);
}

}  // namespace
}  // namespace gluray::test
