// Surfaces that cut each other or nearly coincide, in framebuffers with 16 bits of depth: there the order of
// drawing decides more often than distance.
#include "scenes/stage.h"
#include "tests/reference/both.h"
#include "tests/reference/framebuffer.h"

#include <string>

namespace gluray::test::coarse_depths {
namespace {

using namespace scenes;

constexpr int kWidth = 160, kHeight = 120;

struct Kind {
  GLenum depth = GL_DEPTH_COMPONENT16, function = GL_LESS;
  GLsizei samples = 0;
  bool culls = false, offset = false;
};

void resolve(Gl gl) {
  GLint from = 0, to = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &from);
  bindNewFramebuffer(gl, {kWidth, kHeight}, GL_RGBA8, GL_DEPTH_COMPONENT16);
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &to);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(from));
  gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                     GL_NEAREST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(to));
}

/// A deep view: most surfaces share the steps near the far end.
void prepare(Gl gl, const Kind& kind) {
  bindNewFramebuffer(gl, {kWidth, kHeight}, GL_RGBA8, kind.depth, kind.samples);
  begin(gl, kWidth, kHeight);
  gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity();
  gl.Frustum(-0.0133, 0.0133, -0.01, 0.01, 0.03, 50);
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
  gl.Translatef(0, 0, -4), gl.Rotatef(20, 1, 0.5f, 0);
  gl.DepthFunc(kind.function);
  const bool largest = kind.function == GL_GREATER || kind.function == GL_GEQUAL;
  gl.DepthRange(largest ? 1 : 0, largest ? 0 : 1), gl.ClearDepth(largest ? 0 : 1);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  if (kind.culls) gl.Enable(GL_CULL_FACE);
  if (kind.offset) gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(1, 1);
}

void paintedAt(Gl gl, const Model& model, const Color& color, float z, float scale) {
  gl.Color4fv(color.data());
  sendAt(gl, model, 0, 0, z, scale, 0);
}

/// Sheets one behind the other by less than a step, balls of nearly one size, a ring through both.
void nearlyCoincide(Gl gl) {
  paintedAt(gl, scenes::sheet(12), {0.9f, 0.2f, 0.1f, 1}, -0.4f, 1.1f);
  paintedAt(gl, scenes::sheet(15), {0.1f, 0.8f, 0.2f, 1}, -0.401f, 1.1f);
  paintedAt(gl, scenes::sphere(16, 24), {0.2f, 0.3f, 0.9f, 1}, 0, 0.7f);
  paintedAt(gl, scenes::sphere(20, 30), {0.9f, 0.9f, 0.2f, 1}, 0, 0.7005f);
  paintedAt(gl, scenes::torus(0.7f, 0.12f, 36, 12), {0.6f, 0.1f, 0.7f, 1}, 0, 1);
}

scenes::Tolerance toleranceOf(const Kind& kind) {
  // Vertices on a grid of 1/256 pixel move depths by a fraction of a step, and so the ends of strips of one
  // depth by less than a pixel.
  return {2, kind.samples > 0 ? 0.02 : 0.004, 2.0f / 65535, "ends of strips of one depth; a step"};
}

gl::Statistics compared(const std::string& name, const Kind& kind, const Draw& surfaces = nearlyCoincide) {
  BothStage stage{kWidth, kHeight, "coarse_depths", [&](Gl gl) { prepare(gl, kind); }};
  stage.tolerance = toleranceOf(kind);
  if (kind.samples > 0) stage.tolerance.depth = 2e-2f;  // of any sample
  return compareBoth(stage, name, [&](Gl gl) {
    surfaces(gl);
    if (kind.samples > 0) resolve(gl);
  });
}

DrawnImage pictureOf(const Kind& kind) {
  const auto real = OsmesaContext::create({kWidth, kHeight});
  prepare(real->real(), kind);
  nearlyCoincide(real->real());
  return readImage(real->real(), kWidth, kHeight);
}

TEST(CoarseDepths, DifferFromFineOnes) {
  const Comparison c = compare(pictureOf({}), pictureOf({GL_DEPTH_COMPONENT24}), toleranceOf({}));
  EXPECT_FALSE(c.accepted) << "the surfaces are too far apart for this test: " << c.text;
}

TEST(CoarseDepths, AreThoseOfTheRealOpenGL) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL})
    for (const bool culls : {false, true}) {
      const std::string name = "function " + std::to_string(function) + (culls ? " culled" : "");
      const gl::Statistics counted = compared(name, {.function = function, .culls = culls});
      EXPECT_EQ(counted.drawsTraced, 5u) << name;
    }
}

TEST(CoarseDepths, InTheSamplesOfAPixel) {
  EXPECT_EQ(compared("samples", {.samples = 4}).drawsTraced, 5u);
  EXPECT_EQ(compared("samples lequal", {.function = GL_LEQUAL, .samples = 4}).drawsTraced, 5u);
}

TEST(CoarseDepths, WithPolygonOffset) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL})
    EXPECT_EQ(
        compared("offset " + std::to_string(function), {.function = function, .offset = true}).drawsTraced,
        5u);
}

TEST(CoarseDepths, MeetRasterisedSurfaces) {
  const auto draw = [](Gl gl) {
    paintedAt(gl, scenes::sphere(16, 24), {0.2f, 0.3f, 0.9f, 1}, 0, 0.7f);
    gl.Enable(GL_STENCIL_TEST);
    paintedAt(gl, scenes::sphere(20, 30), {0.9f, 0.9f, 0.2f, 1}, 0, 0.7005f);
    gl.Disable(GL_STENCIL_TEST);
    paintedAt(gl, scenes::sphere(18, 27), {0.1f, 0.8f, 0.2f, 1}, 0, 0.701f);
  };
  for (const GLenum function : {GL_LESS, GL_LEQUAL})
    EXPECT_EQ(
        compared("rasterised between " + std::to_string(function), {.function = function}, draw).drawsTraced,
        2u);
}

TEST(CoarseDepths, WithinTwoStepsAreLeftToTheRealOpenGL) {
  const auto draw = [](Gl gl) {
    gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity();
    gl.Ortho(-1.6, 1.6, -1.2, 1.2, -1e5, 1e5);
    gl.MatrixMode(GL_MODELVIEW);
    paintedAt(gl, scenes::sphere(16, 24), {0.2f, 0.3f, 0.9f, 1}, 0, 0.7f);
    paintedAt(gl, scenes::torus(0.7f, 0.12f, 36, 12), {0.6f, 0.1f, 0.7f, 1}, 0, 1);
  };
  const gl::Statistics counted = compared("thin", {}, draw);
  EXPECT_EQ(counted.drawsTraced, 0u);
  EXPECT_EQ(counted.rasterisedBecause[static_cast<size_t>(gl::Reason::flat)], 2u);
}

TEST(CoarseDepths, WithAlphaTestAreLeftToTheRealOpenGL) {
  const auto draw = [](Gl gl) {
    gl.Enable(GL_ALPHA_TEST), gl.AlphaFunc(GL_GREATER, 0.5f);
    nearlyCoincide(gl);
  };
  const gl::Statistics counted = compared("alpha test", {}, draw);
  EXPECT_EQ(counted.rasterisedBecause[static_cast<size_t>(gl::Reason::alphaTest)], 5u);
}

}  // namespace
}  // namespace gluray::test::coarse_depths
