// Lines of fixed function as tubes: silhouettes, colours, depth.
#include "tests/reference/lines/lines_stage.h"

namespace gluray::test {
namespace {

/// A white line at z = -2 across the window, through its middle, `width` pixels wide.
DrawLines across(float width, float slope = 0) {
  return [=](const gl::RealGl& gl) {
    gl.LineWidth(width);
    gl.Color3f(1, 1, 1);
    gl.Begin(GL_LINES);
    gl.Vertex3f(-2.5f, -2.5f * slope + 0.01f, -2), gl.Vertex3f(2.5f, 2.5f * slope + 0.01f, -2);
    gl.End();
  };
}

TEST(Tubes, AreAsWideAsTheLine) {
  for (const float width : {1.0f, 2.0f, 5.0f, 12.0f}) {
    SCOPED_TRACE(width);
    const LineImage flat = drawnFlat(across(width)), round = drawnRound(across(width));
    EXPECT_EQ(round.statistics.drawsTraced, 1u);
    for (int x = 0; x < kLineStage; ++x)
      EXPECT_NEAR(round.coveredInColumn(x), flat.coveredInColumn(x), 1) << "column " << x;
  }
}

TEST(Tubes, ShineInTheMiddleAndDarkenTowardsTheirSides) {
  const LineImage round = drawnRound(across(16));
  EXPECT_GE(round.channel(32, 32, 0), 250);
  EXPECT_EQ(round.channel(32, 32, 3), 255);
  // The axis is at 32.16. Perspective makes the tube slightly wider than 16 pixels.
  EXPECT_NEAR(round.channel(32, 38, 0), 255 * std::sqrt(1 - 6.34 * 6.34 / 64), 12);
  EXPECT_NEAR(round.channel(32, 25, 0), 255 * std::sqrt(1 - 6.66 * 6.66 / 64), 12);
}

TEST(Tubes, HaveTheDepthOfTheirSurface) {
  const LineImage flat = drawnFlat(across(16)), round = drawnRound(across(16));
  // 8 of 64 pixels of a window 4 units wide: the radius is 0.5, so the tube begins at z = -1.5.
  const auto depth = [](double z) { return 0.5 * (2 * (8 - z) - 15) / (8 - z) + 0.5; };
  EXPECT_NEAR(flat.depth(32, 32), depth(-2), 1e-4);
  EXPECT_NEAR(round.depth(32, 32), depth(-1.5), 1e-3);
}

TEST(Tubes, AreOffByDefaultAndThenLinesStayLines) {
  const LineImage flat = drawnFlat(across(7)), ours = drawnRound(across(7), TracedContext::tracing());
  EXPECT_EQ(ours.image.colors, flat.image.colors);
  EXPECT_EQ(ours.image.depths, flat.image.depths);
  EXPECT_EQ(rasterisedBecause(ours, gl::Reason::lines), 1u);
}

}  // namespace
}  // namespace gluray::test
