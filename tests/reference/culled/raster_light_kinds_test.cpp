// Light on surfaces that the real OpenGL draws, of all kinds of draws and framebuffers, and from all lights.
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

/// Indices that begin primitives anew are no vertices.
TEST(RasterLight, LeavesRestartedPrimitivesAlone) {
  const auto image = [](bool on) {
    const CountedImage got = seen(lit(on), [](Gl gl) {
      const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
      const std::vector<GLuint> indices{0, 1, 2, ~0u, 3, 4, 5};
      GLuint buffer = 0;
      gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
      gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                    indices.data(), GL_STATIC_DRAW);
      gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(~0u);
      draw(gl, program, corner(), view(), kTint, static_cast<GLsizei>(indices.size()));
      gl.Disable(GL_PRIMITIVE_RESTART);
    });
    EXPECT_EQ(got.counts.drawsLit, 0u);
    return got.image.colors;
  };
  EXPECT_EQ(image(true), image(false));
}

TEST(RasterLight, LightsMultisampledFramebuffers) {
  const auto resolved = [](const char* fragment, gl::Statistics* counts) {
    const CountedImage got = seen(lit(true), [&](Gl gl) {
      bindNewFramebuffer(gl, {kSize, kSize}, GL_RGBA8, GL_DEPTH_COMPONENT24, 4);
      begin(gl);
      draw(gl, makeProgram(gl, kFlatVertex, fragment), corner());
      gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
      gl.BlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
      gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    });
    *counts = got.counts;
    return got.image;
  };
  gl::Statistics counts;
  const DrawnImage sampled = resolved(kFlatFragment, &counts), single = byProgram(lit(true)).image;
  EXPECT_EQ(counts.drawsLit, 1u);
  expectAlike(sampled, single, 5);  // edges: blocks of eight pixels, one of which is half covered
  // Where holes are is not known.
  resolved(kHoles, &counts);
  EXPECT_EQ(counts.drawsLit, 0u);
}

/// What is drawn after the surfaces and in front of them shows no light of theirs.
TEST(RasterLight, StaysBelowWhatIsDrawnLater) {
  const glm::vec3 red(1, 0, 0);
  const Triangles front = square(0.5f, 0.3f);
  for (const bool tested : {true, false}) {
    const CountedImage got = seen(lit(true), [&](Gl gl) {
      const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
      draw(gl, program, corner());
      if (!tested) gl.Disable(GL_DEPTH_TEST);
      draw(gl, program, front, view(), red);
    });
    const uint32_t color = at(got.image, {0, 0.5f, 0});
    EXPECT_EQ(channel(color, 1), 0);
    if (!tested) { EXPECT_EQ(channel(color, 0), 255) << "it has no depth: it takes no light"; }
  }
}

/// Surfaces of several draws occlude each other, each with a matrix of its own, and so do traced ones.
TEST(RasterLight, JoinsDrawsOfAllKinds) {
  const Triangles floor = square(0, 1), lid = square(0.1f, 0.5f);
  const glm::vec3 below(0.53f, 0, 0.3f), away(0.9f, 0, -0.9f);  // beside the lid's edge, and far from it
  const auto share = [&](const std::function<void(Gl)>& frame) {
    const CountedImage got = seen(lit(true), frame);
    EXPECT_GT(got.counts.drawsLit, 0u);
    EXPECT_GT(channel(at(got.image, away), 0), 190);
    return channel(at(got.image, below), 0) / 204.0;
  };
  const glm::mat4 raised = view() * glm::translate(glm::mat4(1), glm::vec3(0, 0.1f, 0));
  const double oneDraw = share([&](Gl gl) {
    Triangles both = floor;
    both.insert(both.end(), lid.begin(), lid.end());
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), both);
  });
  const double twoDraws = share([&](Gl gl) {
    const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
    draw(gl, program, floor);
    draw(gl, program, square(0, 0.5f), raised);
  });
  const double tracedLid = share([&](Gl gl) {
    drawTraced(gl, lid);
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), floor);
  });
  EXPECT_LT(oneDraw, 0.8);
  EXPECT_NEAR(twoDraws, oneDraw, 0.03);
  EXPECT_NEAR(tracedLid, oneDraw, 0.06) << "bounds, and with them the radius, are those of both";
}

TEST(RasterLight, ShadowsAreThoseOfARig) {
  Settings settings = TracedContext::tracing();
  settings.light.rasterised = true;
  settings.shadows.enabled = true;
  const auto image = [&](LightRig rig, bool rasterised) {
    settings.lights.rig = rig, settings.light.rasterised = rasterised;
    return seen(settings,
                [](Gl gl) {
                  const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
                  draw(gl, program, square(0, 1));
                  draw(gl, program, square(0.4f, 0.3f));
                })
        .image;
  };
  const DrawnImage none = image(LightRig::program, true), sun = image(LightRig::sun, true);
  size_t darker = 0, brighter = 0;
  for (size_t i = 0; i < none.colors.size(); ++i) {
    darker += channel(sun.colors[i], 0) < channel(none.colors[i], 0) - 20;
    brighter += channel(sun.colors[i], 0) > channel(none.colors[i], 0);
  }
  EXPECT_GT(darker, 50u);
  EXPECT_LT(darker, none.colors.size() / 4);
  EXPECT_EQ(brighter, 0u);
  EXPECT_EQ(none.colors, image(LightRig::program, false).colors) << "no light is known";
}

}  // namespace
}  // namespace gluray::test::raster_light
