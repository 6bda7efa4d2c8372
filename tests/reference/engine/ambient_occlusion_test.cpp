// Ambient occlusion from a program's calls to its framebuffer: colours change, depth and alpha do not, and
// switched off nothing does.
#include "tests/reference/engine/quad.h"
#include "tests/support/traced_context.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

constexpr int kCornerSize = 64;

/// A slightly tilted floor that fills the window, and a wall on it at the right, seen edge-on.
DrawnImage cornerImage(const Settings& settings) {
  TracedContext context({kCornerSize, kCornerSize}, settings);
  const gl::RealGl& gl = context.gl();
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Color4f(1, 1, 1, 0.5f);
  quad(gl, {-1, -1, 0.5f}, {1, -1, 0.51f}, {1, 1, 0.51f}, {-1, 1, 0.5f});
  quad(gl, {0.9f, -1, 0.51f}, {0.95f, -1, -0.9f}, {0.95f, 1, -0.9f}, {0.9f, 1, 0.51f});
  gl.Finish();
  EXPECT_GT(context.context().counts.statistics.drawsTraced, 0u);
  return context.read();
}

Settings fineAo(bool on) {
  Settings settings = TracedContext::tracing();
  settings.ao.enabled = on;
  settings.ao.samples = 256;
  settings.ao.radius = 1;
  return settings;
}

TEST(AmbientOcclusionInPrograms, DarkensCornersAndKeepsDepthAndAlpha) {
  const DrawnImage off = cornerImage(fineAo(false)), on = cornerImage(fineAo(true));
  ASSERT_EQ(off.depths, on.depths);
  const auto channel = [](const DrawnImage& image, int x, int c) {
    return static_cast<int>(image.colors[static_cast<size_t>(kCornerSize / 2 * kCornerSize + x)] >> (8 * c) &
                            255);
  };
  const int beside = 59, away = 4;
  EXPECT_EQ(channel(off, beside, 0), 255);
  EXPECT_EQ(channel(off, away, 0), 255);
  EXPECT_NEAR(channel(on, beside, 0), 140, 25) << "nearly half of the sky is hidden";
  EXPECT_GT(channel(on, away, 0), 215);
  EXPECT_LT(channel(on, away, 0), 255);
  for (const int x : {beside, away}) EXPECT_EQ(channel(on, x, 3), channel(off, x, 3));
}

TEST(AmbientOcclusionInPrograms, SwitchedOffChangesNoBitWhateverElseIsSet) {
  Settings settings = fineAo(false);
  settings.ao.strength = 0.3f, settings.ao.samples = 1;
  const DrawnImage plain = cornerImage(TracedContext::tracing()), off = cornerImage(settings);
  EXPECT_EQ(plain.colors, off.colors);
  EXPECT_EQ(plain.depths, off.depths);
}

TEST(AmbientOcclusionInPrograms, ChangesTheImageOnlyWhileItIsOn) {
  EXPECT_FALSE(fineAo(false).changesImage());
  EXPECT_TRUE(fineAo(true).changesImage());
}

}  // namespace
}  // namespace gluray::test
