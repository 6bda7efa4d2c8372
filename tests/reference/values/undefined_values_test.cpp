// State whose effect the specification leaves undefined, or that the real OpenGL treats differently: draws
// under it are left to the real OpenGL, whose image is then that of the program.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
using Draw = std::function<void(Gl)>;

constexpr int kSize = 32;
constexpr GLfloat kWhite[4] = {1, 1, 1, 1}, kOrange[4] = {0.8f, 0.4f, 0.2f, 1};

/// A tilted triangle; `normal` is that of its last corner.
void triangle(Gl gl, float depth, const GLfloat (&normal)[3] = {0, 0, 1}) {
  gl.Begin(GL_TRIANGLES);
  gl.Normal3f(0, 0, 1), gl.Vertex3f(-1, -1, depth), gl.Vertex3f(1, -1, depth + 0.1f);
  gl.Normal3fv(normal), gl.Vertex3f(0, 1, depth + 0.2f);
  gl.End();
}

void begin(Gl gl) {
  gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Both images, and why draws were rasterised.
void expectLeftAlone(const Draw& draw, gl::Reason reason, uint64_t draws) {
  const auto real = OsmesaContext::create({kSize, kSize});
  draw(real->real());
  const DrawnImage expected = readImage(real->real(), kSize, kSize);
  const TracedContext ours({kSize, kSize});
  draw(ours.gl());
  const DrawnImage got = ours.read();
  EXPECT_EQ(got.colors, expected.colors);
  EXPECT_EQ(got.depths, expected.depths);
  EXPECT_EQ(ours.context().counts.statistics.rasterisedBecause[static_cast<size_t>(reason)], draws);
}

TEST(UndefinedValues, ShortNormalsThatBecomeUnitVectors) {
  for (const float length : {1e-25f, 1e-20f})
    expectLeftAlone(
        [&](Gl gl) {
          begin(gl), gl.Enable(GL_NORMALIZE), triangle(gl, 0, {0, length, length});
        },
        gl::Reason::notFinite, 1);
}

TEST(UndefinedValues, NormalsWithoutDirectionAreTracedOtherwise) {
  const TracedContext ours({kSize, kSize});
  begin(ours.gl()), triangle(ours.gl(), 0, {0, 0, 0});
  (void)ours.read();
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 1u);
}

TEST(UndefinedValues, PolygonOffsetOfLinesOrPointsAlone) {
  for (const GLenum offset : {GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
    expectLeftAlone(
        [&](Gl gl) { begin(gl), gl.Enable(offset), gl.PolygonOffset(1.5f, 20000), triangle(gl, 0); },
        gl::Reason::polygonOffset, 1);
}

/// Both surfaces are drawn by the real OpenGL at last: the first one without the offset.
TEST(UndefinedValues, PolygonOffsetOfLinesAfterTheSameSurface) {
  expectLeftAlone(
      [&](Gl gl) {
        begin(gl), triangle(gl, 0), gl.Enable(GL_POLYGON_OFFSET_LINE), gl.PolygonOffset(-1.5f, -20000);
        gl.Disable(GL_LIGHTING), triangle(gl, 0);
      },
      gl::Reason::polygonOffset, 1);
}

TEST(UndefinedValues, MaterialsOfListsThatFollowTheColor) {
  expectLeftAlone(
      [&](Gl gl) {
        begin(gl), gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, kWhite);
        gl.NewList(1, GL_COMPILE), gl.Begin(GL_TRIANGLES);
        for (const float x : {-1.0f, 1.0f, 0.0f})
          gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, kOrange), gl.Vertex3f(x, x * x, 0.1f * x);
        gl.End(), gl.EndList();
        gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT), gl.Enable(GL_COLOR_MATERIAL), gl.CallList(1);
      },
      gl::Reason::colorMaterial, 1);
}

}  // namespace
}  // namespace gluray::test
