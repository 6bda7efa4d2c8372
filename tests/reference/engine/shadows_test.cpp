// Shadows and light rigs from a program's calls to its framebuffer: colours change, depth and alpha do not,
// and switched off nothing does.
#include "tests/support/traced_context.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

constexpr int kShadowsSize = 64;

void cornersQuad(const gl::RealGl& gl, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                 const glm::vec3& d) {
  gl.Begin(GL_QUADS);
  gl.Normal3f(0, 0, -1);
  for (const glm::vec3* p : {&a, &b, &c, &d}) gl.Vertex3f(p->x, p->y, p->z);
  gl.End();
}

/// A lit floor that fills the window, seen along z, with a light from the right at 45 degrees, and a screen
/// at its right, 0.5 above it, that covers x > 0.75.
DrawnImage screened(const Settings& settings) {
  TracedContext context({kShadowsSize, kShadowsSize}, settings);
  const gl::RealGl& gl = context.gl();
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  const float position[] = {1, 0, -1, 0}, diffuse[] = {1, 1, 1, 1}, color[] = {1, 1, 1, 0.5f};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  cornersQuad(gl, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  cornersQuad(gl, {0.75f, -1, -0.5f}, {3, -1, -0.5f}, {3, 1, -0.5f}, {0.75f, 1, -0.5f});
  gl.Finish();
  EXPECT_GT(context.context().counts.statistics.drawsTraced, 0u);
  return context.read();
}

int channel(const DrawnImage& image, int x, int c) {
  return static_cast<int>(image.colors[static_cast<size_t>(kShadowsSize / 2 * kShadowsSize + x)] >> (8 * c) &
                          255);
}

Settings withShadows(bool on) {
  Settings settings = TracedContext::tracing();
  settings.shadows.enabled = on;
  settings.shadows.size = 0;
  return settings;
}

TEST(ShadowsInPrograms, DarkenWhatTheLightDoesNotReachAndKeepDepthAndAlpha) {
  const DrawnImage off = screened(withShadows(false)), on = screened(withShadows(true));
  ASSERT_EQ(off.depths, on.depths);
  // The global ambient light is 0.2. The shadow begins at x = 0.25: column 40.
  for (int x = 0; x < 56; ++x) {
    EXPECT_NEAR(channel(off, x, 0), 255 * (0.2f + 0.7071f), 1);
    EXPECT_NEAR(channel(on, x, 0), x < 40 ? channel(off, x, 0) : 51, 1) << x;
    EXPECT_EQ(channel(on, x, 3), channel(off, x, 3));
  }
}

TEST(ShadowsInPrograms, AreSoftByDefault) {
  EXPECT_GT(Settings().shadows.size, 0);
  Settings settings = withShadows(true);
  settings.shadows.size = 20;
  const DrawnImage image = screened(settings);
  EXPECT_EQ(channel(image, 10, 0), channel(image, 30, 0));
  EXPECT_LT(channel(image, 40, 0), channel(image, 30, 0) - 10);
  EXPECT_GT(channel(image, 40, 0), channel(image, 50, 0) + 10);
}

TEST(ShadowsInPrograms, SwitchedOffChangeNoBitWhateverElseIsSet) {
  Settings settings = withShadows(false);
  settings.shadows.strength = 0.3f, settings.shadows.samples = 1;
  settings.lights.azimuth = 10, settings.lights.strength = 5;
  const DrawnImage plain = screened(TracedContext::tracing()), off = screened(settings);
  EXPECT_EQ(plain.colors, off.colors);
  EXPECT_EQ(plain.depths, off.depths);
  EXPECT_FALSE(settings.changesImage());
}

TEST(ShadowsInPrograms, RigsReplaceTheProgramsLights) {
  Settings settings = withShadows(false);
  settings.lights.rig = LightRig::headlightAndKey;
  settings.lights.azimuth = -90, settings.lights.elevation = 0;
  settings.lights.attached = LightsAttached::camera;
  EXPECT_TRUE(settings.changesImage());
  const DrawnImage image = screened(settings);
  // The key grazes the floor: the light at the viewer is left, 0.4 / |(1, 0.4)|.
  EXPECT_NEAR(channel(image, 20, 0), 255 * (0.2f + 0.3714f), 3);
}

TEST(ShadowsInPrograms, ALightFileAloneChangesTheImage) {
  Settings settings = TracedContext::tracing();
  settings.lights.file = "lights.toml";
  EXPECT_TRUE(settings.changesImage());
}

}  // namespace
}  // namespace gluray::test
