// Light on tubes and spheres: the program's lights, fog, clip planes, ambient occlusion, and surfaces beside
// them.
#include "tests/reference/lines/lines_stage.h"

#include <algorithm>

namespace gluray::test {
namespace {

void line(const gl::RealGl& gl, float x, float z = -2) {
  gl.Begin(GL_LINES);
  gl.Vertex3f(x, -3, z), gl.Vertex3f(x, 3, z);
  gl.End();
}

/// Slightly tilted: flat layers are not traced.
void facingQuad(const gl::RealGl& gl, float z) {
  gl.Begin(GL_QUADS);
  for (const auto& [x, y] : {std::pair(-4.0f, -4.0f), {4.0f, -4.0f}, {4.0f, 4.0f}, {-4.0f, 4.0f}})
    gl.Vertex3f(x, y, z + 0.002f * y);
  gl.End();
}

TEST(LitTubes, FollowTheProgramsLights) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    const float right[] = {1, 0, 0, 0}, dark[] = {0, 0, 0, 1}, red[] = {1, 0, 0, 1}, white[] = {1, 1, 1, 1};
    gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, right);
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, white);
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, dark);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, red);
    gl.LineWidth(20);
    gl.Normal3f(-1, 0, 0);  // of the line: the tube has its own
    line(gl, 0.03f);
  });
  EXPECT_EQ(round.statistics.drawsTraced, 1u);
  EXPECT_GT(round.channel(40, 32, 0), 180) << "the side towards the light";
  EXPECT_EQ(round.channel(25, 32, 0), 0) << "the other side";
  EXPECT_EQ(round.channel(40, 32, 1), 0);
}

TEST(LitTubes, FadeIntoFog) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    const float fog[] = {0, 1, 0, 1};
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogf(GL_FOG_START, 9), gl.Fogf(GL_FOG_END, 10);
    gl.Fogfv(GL_FOG_COLOR, fog);
    gl.LineWidth(16);
    line(gl, 0.03f);  // its surface begins 9.5 from the eye
  });
  EXPECT_NEAR(round.channel(32, 32, 0), 128, 6);
  EXPECT_GE(round.channel(32, 32, 1), 250);
}

TEST(LitTubes, HideAndAreHiddenByDepth) {
  const auto draw = [](float z) {
    return [=](const gl::RealGl& gl) {
      gl.Color3f(0, 0, 1);
      facingQuad(gl, z);
      gl.Color3f(1, 1, 1);
      gl.LineWidth(16);
      line(gl, 0.03f);
    };
  };
  // The tube reaches from z = -2.5 to z = -1.5.
  const LineImage before = drawnRound(draw(-1.4f)), within = drawnRound(draw(-1.6f)),
                  behind = drawnRound(draw(-2.7f));
  EXPECT_EQ(before.channel(32, 32, 0), 0);
  EXPECT_GE(within.channel(32, 32, 0), 245);
  EXPECT_GE(behind.channel(32, 32, 0), 245);
  const auto visible = [](const LineImage& p) {
    int count = 0;
    for (int x = 0; x < kLineStage; ++x) count += p.channel(x, 32, 1) > 0;
    return count;
  };
  EXPECT_LT(visible(within), visible(behind)) << "the quad cuts through the tube's front";
}

TEST(LitTubes, ClipPlanesCutTheLine) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    const double plane[] = {0, 1, 0, 0};
    gl.ClipPlane(GL_CLIP_PLANE0, plane);
    gl.Enable(GL_CLIP_PLANE0);
    gl.LineWidth(6);
    line(gl, 0.03f);
  });
  EXPECT_TRUE(round.covered(32, 50));
  EXPECT_TRUE(round.covered(32, 33));
  EXPECT_FALSE(round.covered(32, 26));
  EXPECT_FALSE(round.covered(32, 10));
}

Settings withOcclusion() {
  Settings settings = asTubes();
  settings.ao.enabled = true;
  settings.ao.samples = 256;
  settings.ao.distance = 2;
  return settings;
}

TEST(LitTubes, DarkenWhereAnotherTubeIsNear) {
  const auto draw = [](bool pair) {
    return [=](const gl::RealGl& gl) {
      gl.LineWidth(14);
      line(gl, -0.5f);
      if (pair) line(gl, 0.42f);
    };
  };
  const LineImage alone = drawnRound(draw(false), withOcclusion()),
                  pair = drawnRound(draw(true), withOcclusion());
  const int side = 28;  // of the left tube, towards the other one
  ASSERT_TRUE(alone.covered(side, 32));
  EXPECT_LT(pair.channel(side, 32, 0), alone.channel(side, 32, 0) * 0.88);
  EXPECT_GT(pair.channel(18, 32, 0), alone.channel(18, 32, 0) * 0.9) << "the far side stays as it is";
}

TEST(LitTubes, DarkenTheSurfaceThatTheyLieOn) {
  const auto draw = [](bool tube) {
    return [=](const gl::RealGl& gl) {
      gl.Color3f(1, 1, 1);
      facingQuad(gl, -2.6f);
      gl.LineWidth(14);
      if (tube) line(gl, 0.03f);
    };
  };
  const LineImage bare = drawnRound(draw(false), withOcclusion()),
                  with = drawnRound(draw(true), withOcclusion());
  // A tube that is seen between 23 and 78 degrees from the normal: (sin 78 - sin 23) / 2 of the sky is
  // hidden.
  EXPECT_NEAR(with.channel(43, 32, 1), bare.channel(43, 32, 1) * 0.7, 8) << "beside the tube";
  EXPECT_GT(with.channel(63, 32, 1), bare.channel(63, 32, 1) * 0.85) << "away from it";
}

TEST(TubesInUnits, ShrinkWithTheirDistance) {
  Settings settings = asTubes();
  settings.lines.radius = 0.25f;
  const auto width = [&](float z) {
    const LineImage round = drawnRound([=](const gl::RealGl& gl) { line(gl, 0.02f, z); }, settings);
    int count = 0;
    for (int x = 0; x < kLineStage; ++x) count += round.covered(x, 32);
    return count;
  };
  // 0.5 units of 2.4 (6 from the eye) and of 5.6 (14 from the eye).
  EXPECT_NEAR(width(2), 64 * 0.5 / 2.4, 1);
  EXPECT_NEAR(width(-6), 64 * 0.5 / 5.6, 1);
}

TEST(TubesInUnits, ScaleWithTheModelview) {
  Settings settings = asTubes();
  settings.lines.radius = 0.05f;
  const LineImage round = drawnRound(
      [](const gl::RealGl& gl) {
        gl.Scalef(5, 5, 5);
        line(gl, 0.004f, -0.4f);
      },
      settings);
  int count = 0;
  for (int x = 0; x < kLineStage; ++x) count += round.covered(x, 32);
  EXPECT_NEAR(count, 64 * 0.5 / 4, 1.5);
}

TEST(Spheres, AreRoundAndAsLargeAsThePoint) {
  const DrawLines point = [](const gl::RealGl& gl) {
    gl.PointSize(24);
    gl.Begin(GL_POINTS);
    gl.Vertex3f(0.03f, 0.03f, -2);
    gl.End();
  };
  const LineImage flat = drawnFlat(point), round = drawnRound(point);
  EXPECT_NEAR(round.coveredInColumn(32), flat.coveredInColumn(32), 2);
  EXPECT_NEAR(round.coveredInAll(), 3.14159 / 4 * flat.coveredInAll(), 40) << "a disc in a square";
  EXPECT_GE(round.channel(32, 32, 0), 250);
  EXPECT_LT(round.channel(22, 32, 0), 170);
  EXPECT_LT(round.depth(32, 32), flat.depth(32, 32));
}

TEST(Spheres, HaveARadiusInUnits) {
  Settings settings = asTubes();
  settings.points.radius = 0.5f;
  const LineImage round = drawnRound(
      [](const gl::RealGl& gl) {
        gl.Begin(GL_POINTS);
        gl.Vertex3f(0.03f, 0.03f, -2.4f);
        gl.End();
      },
      settings);
  EXPECT_NEAR(round.coveredInColumn(32), 64 / 4.16, 1.5);
}

}  // namespace
}  // namespace gluray::test
