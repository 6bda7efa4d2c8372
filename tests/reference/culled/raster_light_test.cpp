// Light on surfaces that the real OpenGL draws (setting light.rasterised): by programs of no family, it is
// that of the same surfaces traced; depth stays to the bit; and what is not known stays as the program draws
// it.
#include "tests/reference/culled/lit_triangles.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/gl_state.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace gluray::test::raster_light {
namespace {

TEST(RasterLight, OccludesAsIfTheSurfacesWereTraced) {
  const CountedImage traced = seen(lit(false), [](Gl gl) { drawTraced(gl, corner()); });
  const CountedImage drawn = byProgram(lit(true)), plain = byProgram(lit(false));
  ASSERT_EQ(traced.counts.drawsTraced, 1u);
  ASSERT_EQ(drawn.counts.drawsTraced, 0u);
  EXPECT_EQ(drawn.counts.drawsLit, 1u);
  // Noise is 0.01 of white at most; eight pixels beside each other share an edge of the silhouette.
  expectAlike(traced.image, drawn.image, 3);
  EXPECT_LT(channel(at(drawn.image, {-0.95f, 0.02f, -0.95f}), 0), 140) << "most of the sky is hidden";
  EXPECT_EQ(drawn.image.depths, plain.image.depths);
}

/// Text and captions are flattened by a matrix without inverse: they stay as drawn, and the rest stays lit.
TEST(RasterLight, AMatrixWithoutInverseCostsItsOwnDrawAlone) {
  const auto frames = [](Gl gl, bool flattened) {
    const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
    glm::mat4 flat(1);
    flat[2][2] = 0, flat[3] = {0.6f, 0.6f, -2, 1};
    for (int frame = 0; frame < 2; ++frame) {
      begin(gl);
      draw(gl, program, corner());
      if (flattened) draw(gl, program, square(0, 0.01f), flat);
      draw(gl, program, square(0.4f, 0.2f));
    }
  };
  for (const LightIntegrator integrator : {LightIntegrator::local, LightIntegrator::path}) {
    Settings settings = lit(true);
    settings.integrator = integrator;
    const CountedImage with = seen(settings, [&](Gl gl) { frames(gl, true); });
    const CountedImage without = seen(settings, [&](Gl gl) { frames(gl, false); });
    EXPECT_EQ(with.counts.drawsLit, 4u) << "two in each frame";
    EXPECT_EQ(with.counts.rasterisedBecause[static_cast<size_t>(gl::Reason::failure)], 0u);
    size_t different = 0;
    for (size_t i = 0; i < with.image.colors.size(); ++i)
      different += with.image.colors[i] != without.image.colors[i];
    if (integrator == LightIntegrator::local) { EXPECT_LT(different, 30u) << "the text's own"; }
  }
}

TEST(RasterLight, SwitchedOffChangesNoBit) {
  const Settings none = TracedContext::tracing();
  Settings noEffect = none;
  noEffect.light.rasterised = true;
  const DrawnImage expected = byProgram(none).image;
  for (const Settings& settings : {lit(false), noEffect}) {
    const CountedImage got = byProgram(settings);
    EXPECT_EQ(got.counts.drawsLit, 0u);
    EXPECT_EQ(got.image.colors, expected.colors);
    EXPECT_EQ(got.image.depths, expected.depths);
  }
}

TEST(RasterLight, KeepsStateAndShowsNoErrors) {
  const auto stateAfter = [](const Settings& settings) {
    TracedContext context({kSize, kSize}, settings);
    Gl gl = context.gl();
    begin(gl);
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), corner());
    gl.Flush();
    return queryState(gl);
  };
  for (const std::string& line : differences(stateAfter(lit(false)), stateAfter(lit(true))))
    ADD_FAILURE() << line;
}

/// What shows through them is not lit as if they were closed.
TEST(RasterLight, LeavesHolesAlone) {
  const CountedImage plain = byProgram(lit(false), kHoles), got = byProgram(lit(true), kHoles),
                     closed = byProgram(lit(true));
  EXPECT_EQ(got.counts.drawsLit, 1u);
  size_t holes = 0, wrong = 0;
  for (size_t i = 0; i < plain.image.colors.size(); ++i) {
    const bool hole = plain.image.depths[i] == plain.image.depths[0];  // that of the clear
    holes += hole;
    wrong += got.image.colors[i] != (hole ? plain : closed).image.colors[i];
  }
  EXPECT_GT(holes, 1000u);
  EXPECT_EQ(wrong, 0u);
}

/// A lid over a floor, with holes: through them the floor shows, with the light that reaches it.
TEST(RasterLight, LightsWhatShowsThroughHoles) {
  const char* const lidWithHoles = R"(#version 120
uniform vec3 tint;
varying float height;
void main() {
  if (height > 0.05 && fract(gl_FragCoord.x / 16.0) < 0.5) discard;
  gl_FragColor = vec4(tint, 1.0);
})";
  const std::string vertex = std::string(kFlatVertex)
                                 .replace(std::string(kFlatVertex).find("void main() {"), 13,
                                          "varying float height;\nvoid main() { height = position.y;");
  const auto image = [&](bool on) {
    return seen(lit(on),
                [&](Gl gl) {
                  Triangles both = square(0, 1);
                  const Triangles lid = square(0.1f, 0.8f);
                  both.insert(both.end(), lid.begin(), lid.end());
                  draw(gl, makeProgram(gl, vertex, lidWithHoles), both);
                })
        .image;
  };
  const DrawnImage plain = image(false), got = image(true);
  const auto depthOf = [](const glm::vec3& point) {
    const glm::vec4 clip = camera() * view() * glm::vec4(point, 1);
    return 0.5f + 0.5f * clip.z / clip.w;
  };
  int dark = 0, holes = 0;
  for (float x = -0.4f; x < 0.4f; x += 0.02f) {  // below the middle of the lid
    const glm::vec3 point(x, 0, 0.2f);
    const float depth = plain.depths[pixelOf(plain, camera() * view(), point)];
    if (std::abs(depth - depthOf(point)) > 0.002f) continue;
    ++holes, dark += channel(at(got, point), 0) < channel(at(plain, point), 0) / 2;
  }
  EXPECT_GT(holes, 10);
  EXPECT_EQ(dark, holes);
  EXPECT_EQ(got.depths, plain.depths);
}

/// Their depths in the framebuffer lie elsewhere than the surfaces.
TEST(RasterLight, LightsSurfacesWithAPolygonOffset) {
  const CountedImage got = seen(lit(true), [](Gl gl) {
    gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(1, 40);
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), corner());
    gl.Disable(GL_POLYGON_OFFSET_FILL);
  });
  EXPECT_EQ(got.counts.drawsLit, 1u);
  expectAlike(got.image, byProgram(lit(true)).image, 3);
}

}  // namespace
}  // namespace gluray::test::raster_light
