// Fog applies to the sum of the primary and the secondary colour, as in the real OpenGL.
#include "scenes/stage.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using namespace scenes;

constexpr int kFogSize = 96;

/// A ball whose highlight and colour sum up to more than 1, half in fog.
void drawBall(Gl gl, GLenum control, GLenum mode) {
  begin(gl, kFogSize, kFogSize);
  camera(gl, kFogSize, kFogSize);
  const GLfloat white[] = {1, 1, 1, 1}, fog[] = {0.1f, 0.3f, 0.6f, 1}, above[] = {0.3f, 0.5f, 1, 0};
  gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0), gl.Enable(GL_FOG);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, above);
  gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, white), gl.Lightfv(GL_LIGHT0, GL_SPECULAR, white);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, white), gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 4);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, static_cast<GLint>(control));
  gl.Fogi(GL_FOG_MODE, static_cast<GLint>(mode)), gl.Fogf(GL_FOG_DENSITY, 0.12f);
  gl.Fogf(GL_FOG_START, 2), gl.Fogf(GL_FOG_END, 9), gl.Fogfv(GL_FOG_COLOR, fog);
  send(gl, sphere(24, 36));
}

TEST(Fog, TakesTheSumOfBothColors) {
  for (const GLenum control : {GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR})
    for (const GLenum mode : {GL_LINEAR, GL_EXP, GL_EXP2}) {
      const auto real = OsmesaContext::create({kFogSize, kFogSize});
      drawBall(real->real(), control, mode);
      const DrawnImage expected = readImage(real->real(), kFogSize, kFogSize);
      const TracedContext ours({kFogSize, kFogSize});
      drawBall(ours.gl(), control, mode);
      const Comparison c =
          compare(expected, ours.read(), {3, 0.01, 3e-5f, "edges, and lighting at vertices"});
      EXPECT_TRUE(c.accepted) << control << ' ' << mode << ": " << c.text;
      EXPECT_GT(ours.context().counts.statistics.drawsTraced, 0u);
    }
}

}  // namespace
}  // namespace gluray::test
