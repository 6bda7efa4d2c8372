// Only pixels that exist are traced: viewports may be larger than the framebuffer.
#include "tests/reference/both.h"
#include "tests/support/snapshot_taker.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {
namespace {

constexpr int kViewportSize = 200;

/// Adds the regions of its batches to `seen`.
std::unique_ptr<gl::Presenter> takeRegions(std::vector<scene::Region>& seen) {
  return std::make_unique<SnapshotTaker>([&seen](const scene::Snapshot& s) { seen.push_back(s.region); });
}

void drawWith(const gl::RealGl& gl, GLint x, GLint y, GLsizei width, GLsizei height) {
  gl.Enable(GL_DEPTH_TEST);
  gl.Viewport(x, y, width, height);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(-1, -1, 0), gl.Vertex3f(1, -1, 0.1f), gl.Vertex3f(0, 1, 0.2f);
  gl.End();
  gl.Finish();
}

TEST(Viewport, EndsAtTheWindow) {
  std::vector<scene::Region> seen;
  TracedContext context({kViewportSize, kViewportSize}, TracedContext::vertexShading(), takeRegions(seen));
  drawWith(context.gl(), 0, 0, 16384, 16384);
  drawWith(context.gl(), -8000, 50, 16000, 16000);
  drawWith(context.gl(), 10, 20, 30, 40);
  EXPECT_EQ(seen, (std::vector<scene::Region>{{0, 0, kViewportSize, kViewportSize},
                                              {0, 50, kViewportSize, kViewportSize - 50},
                                              {10, 20, 30, 40}}));
}

TEST(Viewport, BesideTheWindowIsNotTraced) {
  std::vector<scene::Region> seen;
  TracedContext context({kViewportSize, kViewportSize}, TracedContext::vertexShading(), takeRegions(seen));
  drawWith(context.gl(), kViewportSize, 0, 100, 100);
  EXPECT_TRUE(seen.empty());
}

/// Drawing order decides which of two surfaces is visible.
TEST(Viewport, WithoutDepthIsNotTraced) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    const BothStage stage{.width = 64, .height = 64, .folder = "viewport", .prepare = [](scenes::Gl) {}};
    const gl::Statistics counts = compareBoth(stage, "equal_depths", [&](scenes::Gl gl) {
      gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(function), gl.DepthRange(0.5, 0.5);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      for (const float z : {0.5f, -0.5f, 0.2f}) {
        gl.Color3f(0.5f + z, 0.5f, 0.2f);
        gl.Begin(GL_TRIANGLES);
        gl.Vertex3f(-1, -1, z), gl.Vertex3f(1, -1, z), gl.Vertex3f(z, 1, z + 0.1f);
        gl.End();
      }
    });
    EXPECT_EQ(counts.drawsTraced, 0u);
  }
}

TEST(Viewport, WindowIsAskedOnceABatch) {
  int width = kViewportSize, asked = 0;
  std::vector<scene::Region> seen;
  const auto presenter = takeRegions(seen);
  const auto below = OsmesaContext::create({kViewportSize, kViewportSize});
  gl::ContextInfo info;
  info.settings.engine = Engine::always;
  info.doubleBuffered = false;
  info.drawableSize = [&] { return ++asked, glm::ivec2(width, kViewportSize); };
  const auto context =
      gl::Context::create(below->real(), std::make_shared<gl::ShareGroup>(), info, *presenter);
  context->makeCurrent();
  const gl::RealGl& gl = TracedContext::stubs();
  const auto batchOfTen = [&] {
    gl.Enable(GL_DEPTH_TEST);
    gl.Viewport(0, 0, 16384, 16384);
    for (int i = 0; i < 10; ++i) {
      gl.Translatef(0.01f, 0, 0);
      gl.Begin(GL_TRIANGLES);
      gl.Vertex3f(-1, -1, 0), gl.Vertex3f(1, -1, 0.1f), gl.Vertex3f(0, 1, 0.2f);
      gl.End();
    }
    gl.Finish();
  };
  batchOfTen();
  EXPECT_EQ(asked, 1);
  width = 2 * kViewportSize;  // the window grows
  batchOfTen();
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(seen, (std::vector<scene::Region>{{0, 0, kViewportSize, kViewportSize},
                                              {0, 0, 2 * kViewportSize, kViewportSize}}));
  context->loseCurrent();
}

}  // namespace
}  // namespace gluray::test
