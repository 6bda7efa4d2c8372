// Surfaces of one view light each other although they are traced in several batches; those of other views do
// not (adr/0047).
#include "tests/reference/engine/lit_program.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <string>

namespace gluray::test::lit {
namespace {

/// Has the real OpenGL draw a blended line at the window's rim.
void blendedLine(Gl gl) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.Color4f(0, 0, 1, 0.5f);
  gl.Begin(GL_LINES);
  gl.Vertex3f(-1, -0.99f, -0.5f), gl.Vertex3f(1, -0.99f, -0.5f);
  gl.End();
  gl.Disable(GL_BLEND);
}

struct LitViewCase {
  const char* name;
  Step between;
};
void PrintTo(const LitViewCase& c, std::ostream* out) { *out << c.name; }

const LitViewCase kSplits[] = {
    {"depthFunction", [](Gl gl) { gl.DepthFunc(GL_LEQUAL); }},
    {"polygonOffset", [](Gl gl) { gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(1, 1); }},
    {"blendedDraw", blendedLine},
    {"readBack",
     [](Gl gl) {
       uint32_t pixel = 0;
       gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
     }},
    {"colorMask", [](Gl gl) { gl.ColorMask(1, 1, 1, 0); }},
    {"scissor",
     [](Gl gl) { gl.Enable(GL_SCISSOR_TEST), gl.Scissor(1, 1, kLitViewSize - 1, kLitViewSize - 1); }},
    {"depthClearElsewhere",
     [](Gl gl) {
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, 3, 3);
       gl.Clear(GL_DEPTH_BUFFER_BIT);
       gl.Disable(GL_SCISSOR_TEST);
     }},
    {"depthClearMasked",
     [](Gl gl) {
       gl.DepthMask(0);
       gl.Clear(GL_DEPTH_BUFFER_BIT);
       gl.DepthMask(1);
     }},
};

class SplitView : public testing::TestWithParam<LitViewCase> {};

TEST_P(SplitView, IsLitAsInOneBatch) {
  LitProgram program(coarseAo());
  const DrawnImage split = program.frame({wall, GetParam().between, floor});
  EXPECT_GE(program.statistics().flushes, 2u);
  const std::vector<int> whole = floorOf(frameOf({wall, floor}));
  EXPECT_EQ(floorOf(split), whole);
  EXPECT_NE(floorOf(frameOf({floor})), whole);
}

INSTANTIATE_TEST_SUITE_P(ViewLight, SplitView, testing::ValuesIn(kSplits),
                         [](const auto& info) { return std::string(info.param.name); });

const LitViewCase kEnds[] = {
    {"depthClear", [](Gl gl) { gl.Clear(GL_DEPTH_BUFFER_BIT); }},
    {"depthClearOfTheViewport",
     [](Gl gl) {
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, kLitViewSize, kLitViewSize);
       gl.Clear(GL_DEPTH_BUFFER_BIT);
       gl.Disable(GL_SCISSOR_TEST);
     }},
    {"otherViewport", [](Gl gl) { gl.Viewport(0, 0, kLitViewSize, kLitViewSize + 1); }},
    {"otherProjection",
     [](Gl gl) {
       gl.MatrixMode(GL_PROJECTION);
       gl.Scalef(1, 1.01f, 1);
       gl.MatrixMode(GL_MODELVIEW);
     }},
};

class OtherView : public testing::TestWithParam<LitViewCase> {};

TEST_P(OtherView, IsNotLitByTheFirst) {
  const auto [name, end] = GetParam();
  EXPECT_EQ(floorOf(frameOf({wall, end, floor})), floorOf(frameOf({nothing, end, floor})));
}

INSTANTIATE_TEST_SUITE_P(ViewLight, OtherView, testing::ValuesIn(kEnds),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ViewLight, AMarkerInACornerNeitherShadesNorIsShaded) {
  const Step marker = [](Gl gl) {
    gl.Viewport(0, 0, 16, 16);
    wall(gl), floor(gl);
    gl.Viewport(0, 0, kLitViewSize, kLitViewSize);
  };
  const Step later = [](Gl gl) { gl.DepthFunc(GL_LEQUAL); };
  LitProgram with(coarseAo()), without(coarseAo());
  for (int i = 0; i < 3; ++i) {
    const DrawnImage marked = with.frame({wall, marker, floor}), plain = without.frame({wall, later, floor});
    for (int y = 16; y < kLitViewSize; ++y)
      for (int x = 4; x < 60; ++x) {
        const auto at = static_cast<size_t>(y * kLitViewSize + x);
        ASSERT_EQ(marked.colors[at], plain.colors[at]) << x << ' ' << y;
      }
  }
}

/// The mean of the floor's pixels.
double meanOf(const std::vector<int>& values) {
  double sum = 0;
  for (const int value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(ViewLight, WhatComesLaterMovesWithTheCamera) {
  const auto turned = [](float degrees) {
    return Step([degrees](Gl gl) { gl.LoadIdentity(), gl.Rotatef(degrees, 0, 0, 1), gl.Scalef(2, 2, 1); });
  };
  LitProgram program(coarseAo());
  for (const float degrees : {0.0f, 10.0f, 20.0f}) {
    const DrawnImage split = program.frame({turned(degrees), floor, kSplit, wall});
    if (degrees == 0) continue;
    const std::vector<int> now = floorOf(split), whole = floorOf(frameOf({turned(degrees), floor, wall})),
                           alone = floorOf(frameOf({turned(degrees), floor}));
    EXPECT_GT(meanOf(alone) - meanOf(whole), 5);
    EXPECT_NEAR(meanOf(now), meanOf(whole), 0.05) << "rays differ by the rounding of matrices alone";
  }
}

TEST(ViewLight, WhatStandsStillIsNotTakenForTurningWithWhatIsDrawnFirst) {
  // What is drawn first spins in its place before a camera that stands still.
  const auto spinning = [](float degrees) {
    return Step([degrees](Gl gl) {
      gl.LoadIdentity(), gl.Rotatef(degrees, 0, 0, 1), gl.Scalef(2, 2, 1);
      floor(gl);
      gl.LoadIdentity();
    });
  };
  LitProgram program(coarseAo());
  for (const float degrees : {0.0f, 90.0f, 180.0f, 270.0f}) {
    const DrawnImage split = program.frame({spinning(degrees), kSplit, wall});
    if (degrees <= 90) continue;  // not known yet
    const std::vector<int> whole = floorOf(frameOf({spinning(degrees), wall}));
    EXPECT_GT(meanOf(floorOf(frameOf({spinning(degrees)}))) - meanOf(whole), 5);
    EXPECT_NEAR(meanOf(floorOf(split)), meanOf(whole), 0.05);
  }
}

TEST(ViewLight, LayersOfRenderersStayApartFromFrameToFrame) {
  // Two cameras' images one over the other, with a depth clear between them; the wall is in the second.
  const Step lowerHalf = [](Gl gl) { quad(gl, {-1, -1, 0.4f}, {1, -1, 0.4f}, {1, 0, 0.4f}, {-1, 0, 0.4f}); };
  const Step speck = [](Gl gl) {
    quad(gl, {-1, -1, -0.9f}, {-0.99f, -1, -0.9f}, {-0.99f, -0.99f, -0.9f}, {-1, -0.99f, -0.9f});
  };
  const Step over = [](Gl gl) { gl.Clear(GL_DEPTH_BUFFER_BIT), gl.DepthFunc(GL_LESS); };
  LitProgram program(coarseAo());
  const auto upper = [](const DrawnImage& image) {
    std::vector<int> result = floorOf(image);
    return std::vector<int>(result.begin() + static_cast<std::ptrdiff_t>(result.size() / 2 + 112),
                            result.end());
  };
  const std::vector<int> alone = upper(frameOf({floor, speck}));
  for (int i = 0; i < 4; ++i) {
    const DrawnImage both = program.frame({floor, kSplit, speck, over, lowerHalf, kSplit, wall});
    EXPECT_EQ(upper(both), alone) << "frame " << i;
  }
}

TEST(ViewLight, SwitchedOffKeepsNothing) {
  LitProgram program(coarseAo(false));
  const Step split = [](Gl gl) { gl.DepthFunc(GL_LEQUAL); };
  const DrawnImage off = program.frame({wall, split, floor});
  EXPECT_TRUE(program.views().empty());
  EXPECT_EQ(off.colors, frameOf({wall, floor}, coarseAo(false)).colors);
}

}  // namespace
}  // namespace gluray::test::lit
