// Depth peeling with other commands between its passes: they find what the real OpenGL would have there.
#include "tests/reference/layers/peeling_stage.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::test {
namespace {

using Hooks = Peeler::Hooks;

TEST(PeelingInterrupted, LinesAmongThemAreDrawnByTheRealOne) {
  auto all = balls();
  all[1].mode = GL_LINES;
  expectPeeled("lines", all, 2 * 1);
}

TEST(PeelingInterrupted, LinesAfterSurfacesThatWaited) {
  auto all = balls();
  all[3].mode = GL_LINES;
  expectPeeled("lines_last", all, 2 * 1);
}

Layer label() { return seen(sheet(1), {1, 1, 0}, 0.5f, placed({0.4, 0.4, 0.9}, 0.2)); }

TEST(PeelingInterrupted, SurfacesAreTracedAtOnceAfterFramesOfLabels) {
  const auto draw = [](Gl gl) {
    Peeler peeler(gl), surfaces(gl);
    for (int frame = 0; frame < 8; ++frame) peeler.frame({label()});
    surfaces.frame(balls());
  };
  expectSame("after_labels", draw, 4, {}, kPeelTolerance);
}

TEST(PeelingInterrupted, SurfacesAmongLabelsAreTracedInTheNextFrame) {
  const auto draw = [](Gl gl) {
    Peeler peeler(gl);
    for (int frame = 0; frame < 8; ++frame) peeler.frame({label()});
    std::vector<Layer> all = balls();
    all.insert(all.begin(), label());
    for (int frame = 0; frame < 3; ++frame) peeler.frame(all);
  };
  expectSame("among_labels", draw, 1 + 5 + 5, {}, kPeelTolerance);
}

TEST(PeelingInterrupted, DepthsFoundAreReadBack) {
  std::vector<std::vector<float>> found;
  const auto hooks = [&](Gl gl, Peeler& peeler) {
    return Hooks{.afterDepths = [&found, &gl, &peeler] {
      std::vector<float> depths(size_t{2} * kProgramWidth * kProgramHeight);
      gl.ActiveTexture(GL_TEXTURE6);
      gl.BindTexture(GL_TEXTURE_2D, peeler.depthsFound());
      gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RG, GL_FLOAT, depths.data());
      found.push_back(std::move(depths));
    }};
  };
  expectPeeled("read_back", balls(), -1, hooks);
  ASSERT_EQ(found.size(), 6u);  // two frames by the real OpenGL, by ours, and by ours where tracing fails
  for (const auto& depths : found) {
    size_t different = 0;
    for (size_t i = 0; i < depths.size(); ++i) different += std::abs(depths[i] - found[0][i]) > 1e-6f;
    EXPECT_EQ(different, 0u);
  }
}

TEST(PeelingInterrupted, ReadPixelsAfterTheFirstPeel) {
  const auto hooks = [](Gl gl, Peeler&) {
    return Hooks{.afterFirstPeel = [&gl] {
      uint32_t pixel = 0;
      gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    }};
  };
  expectPeeled("read_pixels", balls(), 2 * 1, hooks);  // before it is known whether all layers are shown
}

TEST(PeelingInterrupted, AFlushBetweenSurfacesTracesAllOfThemAgain) {
  const auto hooks = [](Gl gl, Peeler&) {
    return Hooks{.betweenSurfaces = [&gl] {
      uint32_t pixel = 0;
      gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    }};
  };
  expectPeeled("flush_between", row(2, 0.4f, 0.2), 2 * 2, hooks);
  // After the first ball it is not known whether all its layers are shown.
  expectPeeled("flush_between_balls", balls(), 2 * 1, hooks);
}

TEST(PeelingInterrupted, DepthsFoundAreClearedByTheProgram) {
  const auto hooks = [](Gl gl, Peeler&) {
    return Hooks{.afterDepths = [&gl] {
      gl.ClearColor(-0.4f, 0.5f, 0, 0);
      gl.Clear(GL_COLOR_BUFFER_BIT);
    }};
  };
  expectPeeled("cleared", balls(), -1, hooks);
}

TEST(PeelingInterrupted, AnotherDrawReadsTheDepths) {
  const auto hooks = [](Gl gl, Peeler& peeler) {
    const GLuint program = makeProgram(
        gl,
        "#version 150\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : "
        "-1., 0., 1.); }",
        "#version 150\nuniform sampler2D depths;\nout vec4 color;\n"
        "void main() { color = vec4(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).y, 0., 0., 0.3); }");
    return Hooks{.afterDepths = [&gl, &peeler, program] {
      GLint now = 0, array = 0;
      gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &now), gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &array);
      gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
      gl.ActiveTexture(GL_TEXTURE6);
      gl.BindTexture(GL_TEXTURE_2D, peeler.depthsFound());
      gl.UseProgram(program);
      setInteger(gl, program, "depths", 6);
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
      gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(now));
    }};
  };
  expectPeeled("another_draw", balls(), -1, hooks);
}

TEST(PeelingInterrupted, SwitchedOff) {
  Settings settings = TracedContext::tracing();
  ASSERT_TRUE(settings.quirks.set("depth-peeling", false));
  TracedContext ours(coreWish(), settings);
  Peeler peeler(ours.gl());
  peeler.frame(balls());
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 1u);
  EXPECT_GT(peeler.peels(), 1);
}

}  // namespace
}  // namespace gluray::test
