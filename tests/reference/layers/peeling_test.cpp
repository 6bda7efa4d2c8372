// Translucent surfaces composited by dual depth peeling: all layers are traced in place of the
// first peel; any other command in between makes the real OpenGL draw the held-back passes.
#include "tests/reference/layers/peeling_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Lights = Surface::Lights;
using Hooks = Peeler::Hooks;

TEST(Peeling, AllLayersAreTracedAtOnce) { expectPeeled("balls", balls(), 2 * 4); }

TEST(Peeling, ProgramsThatAreMadeBetweenThePassesChangeNothing) {
  // As in the first frame, they are made when they are first needed.
  expectBoth(
      "one_frame",
      [](Gl gl) {
        Peeler peeler(gl);
        peeler.frame(balls());
      },
      4, {}, kPeelTolerance);
}

TEST(Peeling, ProgramsCountWhatTheirPeelsWouldHaveWritten) {
  std::vector<std::vector<GLuint>> written;
  const auto draw = [&](Gl gl) {
    Peeler peeler(gl);
    peeler.mostPeels = 20;
    peeler.frame(row(9, 0.2f, 0.1));
    written.push_back(peeler.written());
  };
  expectSame("counts", draw, 9, {}, kPeelTolerance);
  ASSERT_EQ(written.size(), 2u);
  // The last one, which finds one layer, or the one after it.
  for (const auto& counts : written) ASSERT_EQ(counts.size(), 5u);
  for (size_t peel = 0; peel < 5; ++peel) EXPECT_NEAR(written[0][peel], written[1][peel], 32) << peel;
  EXPECT_GT(written[0][3], 1000u);
}

TEST(Peeling, ProgramsStopAfterTheNearestLayerIfAllAreBeforeOpaqueSurfaces) {
  auto all = row(4, 0.4f, 0.2);
  all.push_back(seen(sheet(4), glm::vec3(0.8f), 1, placed({0, 0, -3}, 3)));
  const auto draw = [&](Gl gl) {
    Peeler peeler(gl);
    for (int frame = 0; frame < 3; ++frame) peeler.frame(all);
    EXPECT_EQ(peeler.peels(), 1);
  };
  expectSame("before_opaque", draw, 3, {}, kPeelTolerance);
}

TEST(Peeling, MoreLayersThanTheProgramPeelsAreNotAllShown) {
  const auto all = row(12, 0.2f, 0.1);
  const auto draw = [&](int most, GLuint threshold) {
    return [&, most, threshold](Gl gl) {
      Peeler peeler(gl);
      peeler.mostPeels = most, peeler.threshold = threshold;
      for (int frame = 0; frame < 3; ++frame) peeler.frame(all);
    };
  };
  expectSame("few_peels", draw(4, 0), 0, {}, kPeelTolerance);
  expectSame("high_threshold", draw(20, 4000), 0, {}, kPeelTolerance);
  expectSame("many_peels", draw(20, 0), 3 * 12, {}, kPeelTolerance);
  expectSame("low_threshold", draw(20, 50), 3 * 12, {}, kPeelTolerance);
}

/// Colours and opacities that show the order of compositing, drawn neither front to back nor back to front.
std::vector<Layer> shuffled() {
  std::vector<Layer> all;
  for (int i = 0; i < 10; ++i) {
    const int at = i * 7 % 10;
    const glm::vec3 color(i % 2, 0.1f * static_cast<float>(at), i % 3 == 0);
    all.push_back(seen(sheet(12), color, 0.2f + 0.1f * static_cast<float>(i % 3),
                       placed({0.03 * i, 0.02 * at, 0.6 - 0.12 * at}, 0.7)));
  }
  return all;
}

TEST(Peeling, RemainingLayersAreBlendedInTheOrderOfDrawing) {
  const auto all = shuffled();
  const auto draw = [&](Gl gl) {
    Peeler peeler(gl);
    peeler.blendsRest = true;
    // The first frame of each must not rely on the frame before.
    for (const int most : {1, 1, 3, 2, 20, 2}) {
      peeler.mostPeels = most;
      peeler.frame(all);
    }
  };
  expectSame("rest", draw, 6 * 10, {}, kPeelTolerance);
}

TEST(Peeling, RemainingLayersBeforeAPartlyOpaqueSurface) {
  auto all = shuffled();
  all.push_back(seen(sheet(4), glm::vec3(0.8f), 1, placed({1, 0, -3}, 1.2)));
  const auto draw = [&](Gl gl) {
    Peeler peeler(gl);
    peeler.blendsRest = true;
    peeler.mostPeels = 2;
    for (int frame = 0; frame < 3; ++frame) peeler.frame(all);
    EXPECT_EQ(peeler.peels(), 2);
  };
  expectSame("rest_before_opaque", draw, 3 * 10 + 3, {}, kPeelTolerance);
}

TEST(Peeling, ColorsOfVerticesMapsAndCells) {
  auto all = balls();
  all[0].surface.color = Color::vertex;
  all[1].surface.color = Color::mapped;
  all[3].surface.color = Color::cell;
  all[1].before = [](Gl gl, GLuint program) { setInteger(gl, program, "colortexture", 6); };
  all[3].before = [](Gl gl, GLuint program) { setInteger(gl, program, "textureC", 7); };
  expectPeeled("colors", all, 2 * 4, [mesh = all[3].mesh](Gl gl, Peeler&) {
    colorMap(gl, 6), cellColors(gl, mesh, 7);
    return Hooks{};
  });
}

TEST(Peeling, ImagesThatChangeBetweenPeelsAreNotTraced) {
  auto all = balls();
  all[1].surface.color = Color::mapped;
  all[1].before = [](Gl gl, GLuint program) { colorMap(gl, 6), setInteger(gl, program, "colortexture", 6); };
  expectPeeled("changing_map", all, 2 * 1);
}

TEST(Peeling, WithoutLightsAndByMicrofacets) {
  auto all = balls();
  all[0].surface.lights = Lights::none;
  all[1].surface.lights = Lights::pbr;
  all[3].surface.lights = Lights::headlight;
  expectPeeled("lights", all, 2 * 4);
}

TEST(Peeling, SurfacesWithEdges) {
  auto all = balls();
  for (Layer& layer : all) layer.surface.edges = true;
  all[1].surface.lights = Lights::pbr;
  all[3].surface.lights = Lights::none;
  expectPeeled("peeled_edges", all, 2 * 4);
}

TEST(Peeling, SheetsWithinAnother) {
  std::vector<Layer> all;
  for (int i = 0; i < 5; ++i) {
    const float step = 0.2f * static_cast<float>(i);
    all.push_back(seen(sheet(12), {step, 0.5f, 1 - step}, 0.25f, placed({0, 0, step})));
  }
  all.push_back(seen(ball(16), glm::vec3(1), 1, placed({0, 0, 0.3}, 0.4)));
  expectPeeled("sheets", all, 2 * 6);
}

TEST(Peeling, TwoAtOnePlace) {
  auto all = balls();
  all[1].view = all[0].view;
  expectPeeled("one_place", all, 2 * 4);
}

TEST(Peeling, CulledFacesAreNotSeen) {
  auto all = balls();
  all[0].before = [](Gl gl, GLuint) { gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT); };
  all[1].before = [](Gl gl, GLuint) { gl.Disable(GL_CULL_FACE); };
  all[2].before = all[1].before;
  expectPeeled("culled", all, 2 * 4);
}

/// As in f3d: opaque surfaces go into a framebuffer of floats, which is cleared right before the peels.
TEST(Peeling, AFramebufferOfFloatsIsClearedBefore) {
  GLuint framebuffer = 0;
  const auto clear = [&framebuffer](Gl gl) {
    GLint bound = 0, texture = 0;
    GLfloat color[4] = {};
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound), gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, color);
    GLuint textures[2] = {};
    gl.GenFramebuffers(1, &framebuffer), gl.GenTextures(2, textures);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const auto attach = [&](GLuint name, GLenum attachment, GLint internal, GLenum format) {
      gl.BindTexture(GL_TEXTURE_2D, name);
      gl.TexImage2D(GL_TEXTURE_2D, 0, internal, 16, 16, 0, format, GL_FLOAT, nullptr);
      gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, attachment, GL_TEXTURE_2D, name, 0);
    };
    attach(textures[0], GL_COLOR_ATTACHMENT0, GL_RGBA32F, GL_RGBA);
    attach(textures[1], GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    gl.ClearColor(0, 0, 0, 0), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.ClearColor(color[0], color[1], color[2], color[3]);
    gl.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture));
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  };
  expectPeeled("floats_before", balls(), 2 * 4,
               [&](Gl gl, Peeler&) { return Hooks{.afterDepths = [&clear, &gl] { clear(gl); }}; });
}

// --- What comes between ---------------------------------------------------------------------------------

}  // namespace
}  // namespace gluray::test
