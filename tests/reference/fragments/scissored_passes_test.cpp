// Surfaces that are drawn again in a part of the window: they meet only the depth that is left there.
#include "scenes/stage.h"
#include "tests/reference/both.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace gluray::test {
namespace {

using namespace scenes;

constexpr int kWindowWidth = 160, kWindowHeight = 120;
constexpr std::array<int, 4> kPart = {60, 20, 70, 80};  // x, y, width, height
constexpr std::array<int, 4> kLeft = {0, 0, 80, 120}, kRight = {80, 0, 80, 120};

void scissor(Gl gl, const std::array<int, 4>& to) {
  gl.Enable(GL_SCISSOR_TEST), gl.Scissor(to[0], to[1], to[2], to[3]);
}

void drawFloorAndBall(Gl gl) {
  paint(gl, 0.8f, 0.8f, 0.8f);
  gl.PushMatrix();
  gl.Translatef(0, -0.6f, 0), gl.Rotatef(-80, 1, 0, 0);
  send(gl, scenes::sheet(4));
  gl.PopMatrix();
  paint(gl, 0.3f, 0.5f, 0.7f);
  sendAt(gl, sphere(24, 36), 0.3f, 0, 0.2f, 0.6f);
}

gl::Statistics countsOf(const std::string& name, const Draw& draw) {
  const BothStage stage{kWindowWidth, kWindowHeight, "scissored_passes", [](Gl) {}};
  return compareBoth(stage, name, [&](Gl gl) {
    begin(gl, kWindowWidth, kWindowHeight), camera(gl, kWindowWidth, kWindowHeight), keyLight(gl);
    draw(gl);
    gl.Disable(GL_SCISSOR_TEST);
  });
}

TEST(ScissoredPasses, ThatAreDrawnAgainWhereAllWasClearedAreTraced) {
  const gl::Statistics counts = countsOf("cleared", [](Gl gl) {
    for (int frame = 0; frame < 3; ++frame) {
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      drawFloorAndBall(gl);
      scissor(gl, kPart);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      drawFloorAndBall(gl);
      gl.Disable(GL_SCISSOR_TEST);
    }
  });
  EXPECT_EQ(counts.drawsTraced, 12u);
}

TEST(ScissoredPasses, InTwoHalvesOfTheWindowAreTraced) {
  const gl::Statistics counts = countsOf("halves", [](Gl gl) {
    scissor(gl, kLeft);
    drawFloorAndBall(gl);
    scissor(gl, kRight);
    gl.ShadeModel(GL_FLAT);
    drawFloorAndBall(gl);
    gl.ShadeModel(GL_SMOOTH);
  });
  EXPECT_EQ(counts.drawsTraced, 4u);
}

TEST(ScissoredPasses, OverDepthThatIsLeftAreRasterised) {
  const auto tint = [](Gl gl) {
    gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthFunc(GL_EQUAL);
    drawFloorAndBall(gl);
  };
  EXPECT_LT(
      countsOf("tinted", [&](Gl gl) { drawFloorAndBall(gl), scissor(gl, kPart), tint(gl); }).drawsTraced, 3u);
  // The clear removes the depth of a part; the tint is drawn in all of the window.
  const gl::Statistics counts = countsOf("tinted_outside", [&](Gl gl) {
    drawFloorAndBall(gl);
    scissor(gl, kPart);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
    tint(gl);
  });
  EXPECT_LT(counts.drawsTraced, 3u);
  // Drawn again in the part, and tinted there.
  countsOf("tinted_inside", [&](Gl gl) {
    drawFloorAndBall(gl);
    scissor(gl, kPart);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    drawFloorAndBall(gl);
    tint(gl);
  });
}

TEST(ScissoredPasses, AreFoundWhereTheScissorTestWasOnAndIsOff) {
  countsOf("on_off", [](Gl gl) {
    scissor(gl, kLeft);
    drawFloorAndBall(gl);
    gl.Disable(GL_SCISSOR_TEST);
    gl.DepthFunc(GL_EQUAL);
    paint(gl, 0.2f, 0.9f, 0.2f);
    sendAt(gl, sphere(24, 36), 0.3f, 0, 0.2f, 0.6f);
  });
  countsOf("pushed", [](Gl gl) {
    scissor(gl, kLeft);
    gl.PushAttrib(GL_ENABLE_BIT);
    gl.Disable(GL_SCISSOR_TEST);
    drawFloorAndBall(gl);
    gl.PopAttrib();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawFloorAndBall(gl);
  });
}

}  // namespace
}  // namespace gluray::test
