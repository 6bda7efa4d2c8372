// Lines and points that are odd, that cannot become tubes and spheres, or that change their look.
#include "tests/reference/lines/lines_stage.h"

#include <limits>

namespace gluray::test {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void segment(const gl::RealGl& gl, float x0, float y0, float x1, float y1) {
  gl.Vertex3f(x0, y0, -2), gl.Vertex3f(x1, y1, -2);
}

TEST(OddLines, WithoutLengthAreInvisible) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.LineWidth(9);
    gl.Begin(GL_LINES);
    segment(gl, 0, 0, 0, 0);
    gl.End();
  });
  EXPECT_EQ(round.coveredInAll(), 0);
}

TEST(OddLines, OfOneVertexDrawNothing) {
  for (const GLenum mode : {GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}) {
    const LineImage round = drawnRound([=](const gl::RealGl& gl) {
      gl.Begin(mode);
      gl.Vertex3f(0, 0, -2);
      gl.End();
    });
    EXPECT_EQ(round.coveredInAll(), 0);
  }
}

TEST(OddLines, ThatAreNotFiniteLeaveTheOthers) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.LineWidth(9);
    gl.Begin(GL_LINES);
    segment(gl, kNotANumber, 0, 1, 1), segment(gl, 0, 0, kInfinity, 1), segment(gl, -1, 0.03f, 1, 0.03f);
    gl.End();
  });
  EXPECT_TRUE(round.covered(32, 32));
  EXPECT_FALSE(round.covered(32, 50));
}

TEST(OddLines, DrawnTwiceShowWhatTheDepthFunctionLeaves) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    const LineImage round = drawnRound([=](const gl::RealGl& gl) {
      gl.DepthFunc(function);
      gl.LineWidth(9);
      gl.Begin(GL_LINES);
      gl.Color3f(1, 0, 0), segment(gl, -1, 0.03f, 1, 0.03f);
      gl.Color3f(0, 1, 0), segment(gl, -1, 0.03f, 1, 0.03f);
      gl.End();
    });
    EXPECT_GT(round.channel(32, 32, function == GL_LESS ? 0 : 1), 240);
    EXPECT_EQ(round.channel(32, 32, function == GL_LESS ? 1 : 0), 0);
  }
}

TEST(OddLines, OfTwoWidthsInOnePlaceAreBothThere) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.DepthFunc(GL_LEQUAL);
    for (const float width : {20.0f, 4.0f}) {
      gl.LineWidth(width);
      gl.Begin(GL_LINES);
      segment(gl, -1, 0.03f, 1, 0.03f);
      gl.End();
    }
  });
  EXPECT_NEAR(round.coveredInColumn(32), 20, 2);
}

TEST(OddLines, ThatReachBehindTheViewerStayThere) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.LineWidth(6);
    gl.Begin(GL_LINES);
    gl.Vertex3f(-0.5f, -0.5f, -2.9f), gl.Vertex3f(4, 4, 14);
    gl.End();
  });
  EXPECT_TRUE(round.covered(25, 25)) << "its far end is at -0.5 / 2.18 of the half window";
  EXPECT_GT(round.coveredInAll(), 20);
  EXPECT_LT(round.coveredInAll(), 900);
}

TEST(OddLines, BeyondWhatRaysReachAreLeftToTheRealOpenGl) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.Begin(GL_LINES);
    gl.Vertex3f(-1e25f, 0, -2), gl.Vertex3f(1e25f, 0, -2);
    gl.End();
  });
  EXPECT_EQ(rasterisedBecause(round, gl::Reason::farAway), 1u);
}

void plainStrip(const gl::RealGl& gl) {
  gl.Begin(GL_LINES);
  segment(gl, -1, 0.03f, 1, 0.03f);
  gl.End();
}

/// Why the line is rasterised after `prepare`; its image is then the real OpenGL's.
gl::Reason reasonAfter(const DrawLines& prepare) {
  const auto draw = [&](const gl::RealGl& gl) {
    prepare(gl);
    plainStrip(gl);
  };
  const LineImage flat = drawnFlat(draw), ours = drawnRound(draw);
  EXPECT_EQ(ours.image.colors, flat.image.colors);
  for (int i = 0; i < gl::kReasonCount; ++i)
    if (ours.statistics.rasterisedBecause[static_cast<size_t>(i)] > 0) return static_cast<gl::Reason>(i);
  return gl::Reason::traced;
}

TEST(OddLines, ThatHaveAStyleStayLines) {
  EXPECT_EQ(reasonAfter([](const gl::RealGl& gl) {
              gl.LineStipple(2, 0x5555);
              gl.Enable(GL_LINE_STIPPLE);
            }),
            gl::Reason::lineStyle);
  EXPECT_EQ(reasonAfter([](const gl::RealGl& gl) {
              gl.Enable(GL_LINE_SMOOTH), gl.Enable(GL_BLEND);
              gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            }),
            gl::Reason::blend);
  EXPECT_EQ(reasonAfter([](const gl::RealGl& gl) {
              gl.Enable(GL_BLEND);
              gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
              gl.Color4f(1, 1, 1, 0.5f);
            }),
            gl::Reason::blend);
  EXPECT_EQ(reasonAfter([](const gl::RealGl& gl) { gl.Disable(GL_DEPTH_TEST); }), gl::Reason::noDepthTest);
  EXPECT_EQ(reasonAfter([](const gl::RealGl& gl) { gl.DepthMask(GL_FALSE); }), gl::Reason::depthMask);
}

TEST(OddLines, OfFlatDrawingsStayLines) {
  EXPECT_EQ(reasonAfter([](const gl::RealGl& gl) {
              gl.MatrixMode(GL_PROJECTION);
              gl.LoadIdentity();
              gl.Ortho(-2, 2, -2, 2, 7, 13);
              gl.MatrixMode(GL_MODELVIEW);
            }),
            gl::Reason::flat);
}

TEST(OddLines, PolygonStateDoesNotMatter) {
  EXPECT_EQ(drawnRound([](const gl::RealGl& gl) {
              gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
              gl.Enable(GL_CULL_FACE);
              plainStrip(gl);
            }).statistics.drawsTraced,
            1u);
}

TEST(OddLines, WithAdjacentVerticesStayLines) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.Begin(0x000A);  // GL_LINES_ADJACENCY
    for (const float x : {-2.0f, -1.0f, 1.0f, 2.0f}) gl.Vertex3f(x, 0.03f, -2);
    gl.End();
  });
  EXPECT_EQ(round.statistics.drawsTraced, 0u);
}

TEST(OddLines, SettingsGiveTheirWidth) {
  Settings settings = asTubes();
  settings.lines.width = 11;
  EXPECT_NEAR(drawnRound(plainStrip, settings).coveredInColumn(32), 11, 1);
}

TEST(OddLines, OnlyWhatIsAskedForChanges) {
  Settings settings = asTubes();
  settings.points.look = PointLook::program;
  const LineImage round = drawnRound(
      [](const gl::RealGl& gl) {
        plainStrip(gl);
        gl.Begin(GL_POINTS);
        gl.Vertex3f(0, 1, -2);
        gl.End();
      },
      settings);
  EXPECT_EQ(round.statistics.drawsTraced, 1u);
  EXPECT_EQ(rasterisedBecause(round, gl::Reason::points), 1u);
}

/// The same image at every size of the scene.
TEST(OddLines, OfAnySize) {
  const auto draw = [](double size) {
    return [=](const gl::RealGl& gl) {
      gl.MatrixMode(GL_PROJECTION);
      gl.LoadIdentity();
      gl.Frustum(-size, size, -size, size, size, 3 * size);
      gl.MatrixMode(GL_MODELVIEW);
      gl.LoadIdentity();
      gl.LineWidth(12);
      const auto s = static_cast<float>(size);
      gl.Begin(GL_LINES);
      gl.Vertex3f(-1.5f * s, -1 * s, -2 * s), gl.Vertex3f(1.5f * s, 1.2f * s, -2.4f * s);
      gl.End();
    };
  };
  const LineImage usual = drawnRound(draw(1));
  EXPECT_GT(usual.coveredInAll(), 300);
  for (const double size : {1e-15, 1e-8, 1e8, 1e16}) {
    SCOPED_TRACE(size);
    const LineImage other = drawnRound(draw(size));
    EXPECT_EQ(other.statistics.drawsTraced, 1u);
    EXPECT_NEAR(other.coveredInAll(), usual.coveredInAll(), 8);
    EXPECT_NEAR(other.channel(32, 32, 0), usual.channel(32, 32, 0), 2);
    EXPECT_NEAR(other.depth(32, 32), usual.depth(32, 32), 1e-4);
  }
}

}  // namespace
}  // namespace gluray::test
