// Framebuffers whose colours are floats, and surfaces that are seen through and added up in them (weighted
// blending, as VTK 9.1's vtkOrderIndependentTranslucentPass has it).
#include "tests/reference/layers/peeler.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Lights = Surface::Lights;

GLuint texture(Gl gl, GLenum internalFormat) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), kProgramWidth, kProgramHeight, 0,
                GL_RGBA, GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return name;
}

/// A framebuffer object with a depth buffer, bound.
GLuint framebuffer(Gl gl, std::initializer_list<GLuint> colors) {
  GLuint name = 0, depth = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  std::vector<GLenum> buffers;
  for (const GLuint color : colors) {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, color, 0);
  }
  gl.GenRenderbuffers(1, &depth);
  gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kProgramWidth, kProgramHeight);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  gl.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  return name;
}

void drawOne(Gl gl, GLuint program, const Peeled& one) {
  const Upload uploaded = upload(gl, one.mesh, program);
  gl.UseProgram(program);
  setAll(gl, program, one.view, one.surface);
  setVec3(gl, program, "diffuseColorUniform", one.color);
  setVec3(gl, program, "ambientColorUniform", one.color);
  setFloat(gl, program, "opacityUniform", one.opacity);
  gl.BindVertexArray(uploaded.array);
  if (one.before) one.before(gl, program);
  gl.DrawElements(one.mode, one.mesh.count(), GL_UNSIGNED_INT, nullptr);
}

std::string summedText(const Surface& surface) {
  std::string text = fragmentText(surface);
  text.insert(text.find("void main()"), "out vec4 fragOutput1;\n");
  return text.insert(text.rfind('}'),
                     "  fragOutput0 = vec4(fragOutput0.rgb*fragOutput0.a, fragOutput0.a);\n"
                     "  fragOutput1.r = fragOutput0.a;\n");
}

/// Draws what is opaque, adds up the rest, and puts it over.
class Summer {
 public:
  explicit Summer(Gl gl) : gl_(gl) {
    below_ = framebuffer(gl, {texture(gl, GL_RGBA8)});
    colors_ = texture(gl, GL_RGBA32F), opacities_ = texture(gl, GL_R32F);
    sums_ = framebuffer(gl, {colors_, opacities_});
    over_ = makeProgram(
        gl,
        "#version 150\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : "
        "-1., 0., 1.); }",
        "#version 150\nuniform sampler2D colors, opacities;\nout vec4 fragOutput0;\nvoid main() {\n"
        "  ivec2 at = ivec2(gl_FragCoord.xy);\n  vec4 c = texelFetch(colors, at, 0);\n"
        "  fragOutput0 = vec4(c.rgb / max(texelFetch(opacities, at, 0).r, 0.01), c.a);\n}\n");
    gl.GenVertexArrays(1, &none_);
  }
  std::function<void()> between;  // surfaces that are added up
  GLuint colors() const { return colors_; }
  GLuint opacities() const { return opacities_; }
  GLenum depthFunc = GL_LEQUAL;

  void frame(const std::vector<Peeled>& all) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, below_);
    beginFrame(gl_);
    for (const Peeled& one : all)
      if (one.opacity == 1) drawOne(gl_, makeProgram(gl_, one.surface), one);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, sums_);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                        GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    gl_.DepthFunc(depthFunc);
    bool first = true;
    for (const Peeled& one : all) {
      if (one.opacity == 1) continue;
      if (!first && between) between();
      first = false;
      gl_.DepthMask(GL_FALSE);
      drawOne(gl_, makeProgram(gl_, vertexText(one.surface), summedText(one.surface)), one);
      gl_.DepthMask(GL_TRUE);
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, below_);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BlendFuncSeparate(GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA);
    gl_.UseProgram(over_);
    setInteger(gl_, over_, "colors", 4), setInteger(gl_, over_, "opacities", 5);
    gl_.ActiveTexture(GL_TEXTURE4), gl_.BindTexture(GL_TEXTURE_2D, colors_);
    gl_.ActiveTexture(GL_TEXTURE5), gl_.BindTexture(GL_TEXTURE_2D, opacities_);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindVertexArray(none_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl_.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                        GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.Enable(GL_DEPTH_TEST), gl_.DepthFunc(GL_LEQUAL);
  }

 private:
  Gl gl_;
  GLuint below_ = 0, sums_ = 0, colors_ = 0, opacities_ = 0, over_ = 0, none_ = 0;
};

constexpr scenes::Tolerance kSumTolerance = {2, 0.004, 1e-5f, "silhouettes of all layers"};

void expectSummed(const std::string& name, const std::vector<Peeled>& all, int draws,
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

TEST(Sums, TwoOfOnePlace) {
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
  // Ours are added as they would have been when they were drawn.
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
    std::vector<Peeled> all;
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

// --- Colours as floats -------------------------------------------------------------------------------------

TEST(WideColors, BrighterThanOneStaySo) {
  for (const GLenum format : {GL_RGBA32F, GL_RGBA16F}) {
    std::vector<std::vector<float>> found;
    const auto draw = [&](Gl gl) {
      framebuffer(gl, {texture(gl, format)});
      beginFrame(gl);
      Peeled one = seen(ball(24), {2.5f, 0.7f, 0.3f}, 1, placed({0, 0, 0}));
      one.surface.lights = Lights::headlight;
      drawOne(gl, makeProgram(gl, one.surface), one);
      std::vector<float> colors(size_t{4} * kProgramWidth * kProgramHeight);
      gl.ReadPixels(0, 0, kProgramWidth, kProgramHeight, GL_RGBA, GL_FLOAT, colors.data());
      found.push_back(std::move(colors));
      gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
      gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
      gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    };
    expectSame(format == GL_RGBA32F ? "wide_32" : "wide_16", draw, 1);
    ASSERT_EQ(found.size(), 2u);
    size_t different = 0, bright = 0;
    for (size_t i = 0; i < found[0].size(); ++i) {
      different += std::abs(found[0][i] - found[1][i]) > 4e-3f;
      bright += found[0][i] > 1.5f;
    }
    EXPECT_LT(static_cast<double>(different), 0.002 * static_cast<double>(found[0].size()));
    EXPECT_GT(bright, 1000u);
  }
}

TEST(WideColors, OfWhatTheRealOneDrawsAgain) {
  const auto draw = [](Gl gl) {
    framebuffer(gl, {texture(gl, GL_RGBA32F)});
    beginFrame(gl);
    const Peeled one = seen(ball(24), {2.5f, 0.7f, 0.3f}, 1, placed({0, 0, 0}));
    drawOne(gl, makeProgram(gl, one.surface), one);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  };
  expectSameWhenTracingFails("wide_again", draw);
}

TEST(WideColors, OfFixedFunctionAreDrawnByTheRealOne) {
  const auto draw = [](Gl gl) {
    framebuffer(gl, {texture(gl, GL_RGBA32F)});
    beginFrame(gl);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(2, 0.5f, 0.25f);
    gl.Vertex3f(-0.5f, -0.5f, 0), gl.Vertex3f(0.5f, -0.5f, 0.1f), gl.Vertex3f(0, 0.5f, 0.2f);
    gl.End();
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  };
  ContextWish wish{kProgramWidth, kProgramHeight};
  expectSame("wide_fixed", draw, 0, wish);
}

}  // namespace
}  // namespace gluray::test
