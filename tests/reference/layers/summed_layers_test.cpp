// Translucent surfaces, summed by weighted blending.
#include "tests/reference/layers/summer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Lights = Surface::Lights;

constexpr scenes::Tolerance kSumTolerance = {2, 0.004, 1e-5f, "silhouettes of all layers"};

void expectSummed(const std::string& name, const std::vector<Layer>& all, int draws,
                  const std::function<void(Gl, Summer&)>& prepare = {}) {
  const auto draw = [&](Gl gl) {
    Summer summer(gl);
    if (prepare) prepare(gl, summer);
    summer.frame(all);
    summer.frame(all);
  };
  expectBoth(name, draw, draws, {}, kSumTolerance);
}

TEST(Sums, OfAllLayersAtOnce) { expectSummed("sums", balls(), 2 * 4); }

TEST(Sums, OfColorsOfVerticesMapsAndCells) {
  auto all = balls();
  all[0].surface.color = Color::vertex;
  all[1].surface.color = Color::mapped;
  all[3].surface.color = Color::cell;
  all[1].before = [](Gl gl, GLuint program) { colorMap(gl, 6), setInteger(gl, program, "colortexture", 6); };
  all[3].before = [mesh = all[3].mesh](Gl gl, GLuint program) {
    cellColors(gl, mesh, 7), setInteger(gl, program, "textureC", 7);
  };
  expectSummed("sum_colors", all, 2 * 4);
}

TEST(Sums, WithoutLightsAndByMicrofacets) {
  auto all = balls();
  all[0].surface.lights = Lights::none;
  all[1].surface.lights = Lights::pbr;
  expectSummed("sum_lights", all, 2 * 4);
}

TEST(Sums, OfSurfacesWithEdges) {
  auto all = balls();
  for (Layer& layer : all) layer.surface.edges = true;
  all[1].surface.lights = Lights::none;
  all[3].surface.lights = Lights::pbr;
  expectSummed("sum_edges", all, 2 * 4);
}

TEST(Sums, TwoAtOnePlace) {
  auto all = balls();
  all[1].view = all[0].view;
  expectSummed("sum_one_place", all, 2 * 4);
}

TEST(Sums, LinesAmongThemAreDrawnByTheRealOne) {
  auto all = balls();
  all[1].mode = GL_LINES;
  expectSummed("sum_lines", all, 2 * 3);
}

TEST(Sums, ReadBetweenSurfaces) {
  expectSummed("sum_read", balls(), 2 * 4, [](Gl gl, Summer& summer) {
    summer.between = [&gl] {
      float pixel[4];
      gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel);
    };
  });
}

TEST(Sums, WhereDepthIsWrittenTheRealOneDraws) {
  auto all = balls();
  all[1].before = [](Gl gl, GLuint) { gl.DepthMask(GL_TRUE); };
  expectSummed("sum_depth", all, 2 * 3);
}

TEST(Sums, BlendedOtherwiseTheRealOneDraws) {
  auto all = balls();
  all[1].before = [](Gl gl, GLuint) { gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); };
  all[3].before = [](Gl gl, GLuint) {
    gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  };
  expectSummed("sum_blend", all, 2 * 3);
}

TEST(Sums, BlendedOtherwiseBetweenDrawingAndFlush) {
  // GLuRay's sums are added as they would have been when drawn.
  auto all = balls();
  expectSummed("sum_late_blend", all, 2 * 4, [](Gl gl, Summer& summer) {
    summer.between = [&gl] {
      gl.BlendFuncSeparate(GL_ZERO, GL_ZERO, GL_ZERO, GL_ZERO);
      gl.BlendEquation(GL_FUNC_SUBTRACT);
      gl.Disable(GL_BLEND);
      gl.Flush();
      gl.Finish();
      gl.Enable(GL_BLEND);
      gl.BlendEquation(GL_FUNC_ADD);
      gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    };
  });
}

TEST(Sums, CoplanarWithWhatIsOpaque) {
  for (const GLenum func : {GL_LEQUAL, GL_LESS}) {
    std::vector<Layer> all;
    all.push_back(seen(sheet(12), {1, 0.2f, 0.1f}, 1, placed({0, 0, 0})));
    all.push_back(seen(sheet(12), {0.1f, 0.2f, 1}, 0.5f, placed({0, 0, 0})));
    expectSummed(func == GL_LESS ? "sum_less" : "sum_lequal", all, 2 * 2,
                 [func](Gl, Summer& summer) { summer.depthFunc = func; });
  }
}

TEST(Sums, AreFloatsOfTheSameValue) {
  std::vector<std::vector<float>> found;
  const auto draw = [&](Gl gl) {
    Summer summer(gl);
    summer.frame(balls());
    std::vector<float> sums(size_t{5} * kProgramWidth * kProgramHeight);
    gl.BindTexture(GL_TEXTURE_2D, summer.colors());
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, sums.data());
    gl.BindTexture(GL_TEXTURE_2D, summer.opacities());
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT,
                   sums.data() + size_t{4} * kProgramWidth * kProgramHeight);
    found.push_back(std::move(sums));
  };
  expectSame("sum_values", draw, 4, {}, kSumTolerance);
  ASSERT_EQ(found.size(), 2u);
  size_t different = 0;
  for (size_t i = 0; i < found[0].size(); ++i) different += std::abs(found[0][i] - found[1][i]) > 2e-3f;
  EXPECT_LT(static_cast<double>(different), 0.004 * static_cast<double>(found[0].size()));
}

}  // namespace
}  // namespace gluray::test
