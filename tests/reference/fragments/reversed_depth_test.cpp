// Depth functions GREATER and GEQUAL, with reversed depth ranges and projections: the largest depth is seen.
// Clip depths from 0 to 1 (glClipControl).
#include "gl/real/clip_depths.h"
#include "scenes/stage.h"
#include "tests/reference/both.h"
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <string>

namespace gluray::test {
namespace {

struct Reversal {
  const char* name;
  GLenum function = GL_GREATER;
  bool projection = false;  // maps the near plane to 1
  double near = 0, far = 1, clear = 0;
  bool fromZero = false, infinite = false;  // clip depths; the far plane
};
void PrintTo(const Reversal& reversal, std::ostream* out) { *out << reversal.name; }

constexpr Reversal kLess{.name = "less", .function = GL_LESS, .clear = 1};
constexpr Reversal kRange{.name = "range", .near = 1, .far = 0};
constexpr Reversal kReversals[] = {
    kRange,
    {.name = "range_gequal", .function = GL_GEQUAL, .near = 1, .far = 0},
    {.name = "projection", .projection = true},
    {.name = "projection_gequal", .function = GL_GEQUAL, .projection = true},
    {.name = "farthest"},
    {.name = "both", .projection = true, .near = 1, .far = 0},
    {.name = "clear_between", .near = 0.9, .far = 0.2, .clear = 0.32},
    {.name = "less_by_projection", .function = GL_LESS, .projection = true, .clear = 1},
    {.name = "from_zero", .function = GL_LEQUAL, .clear = 1, .fromZero = true},
    {.name = "from_zero_reversed", .projection = true, .fromZero = true},
    {.name = "from_zero_range", .function = GL_GEQUAL, .near = 1, .far = 0, .fromZero = true},
    {.name = "from_zero_infinite", .projection = true, .fromZero = true, .infinite = true},
};

glm::dmat4 projected(glm::dmat4 clipFromEye, const Reversal& r) {
  if (r.projection) clipFromEye = glm::scale(glm::dmat4(1), {1, 1, -1}) * clipFromEye;
  if (r.fromZero) clipFromEye = gl::toDepthsFromZero(clipFromEye);
  if (r.infinite) clipFromEye[2].z = 0, clipFromEye[3].z = 1;  // the near plane is at 1
  return clipFromEye;
}

void setDepths(Gl gl, const Reversal& r) {
  gl.DepthFunc(r.function), gl.DepthRange(r.near, r.far), gl.ClearDepth(r.clear);
  gl.ClipControl(GL_LOWER_LEFT, r.fromZero ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

constexpr int kReversedWidth = 160, kReversedHeight = 120;

/// Lit surfaces that intersect and hide each other.
void drawLit(Gl gl, const Reversal& r) {
  scenes::begin(gl, kReversedWidth, kReversedHeight);
  setDepths(gl, r);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION);
  const glm::dmat4 projection =
      projected(glm::perspective(glm::radians(40.0), double{kReversedWidth} / kReversedHeight, 1.0, 12.0), r);
  gl.LoadMatrixd(glm::value_ptr(projection));
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity(), gl.Translatef(0, 0, -4), gl.Rotatef(25, 1, 0.3f, 0);
  scenes::keyLight(gl);
  scenes::paint(gl, 0.9f, 0.4f, 0.2f);
  scenes::sendAt(gl, scenes::sphere(24, 32), 0, 0, 0, 0.9f);
  scenes::paint(gl, 0.2f, 0.5f, 0.9f);
  scenes::sendAt(gl, scenes::torus(1, 0.3f, 32, 16), 0.2f, 0.1f, 0, 1);
  scenes::paint(gl, 0.3f, 0.8f, 0.3f);
  scenes::sendAt(gl, scenes::sheet(16), 0, 0, -0.6f, 1.5f);
}

/// Colours as those of other scenes by fixed function, whose vertices are lit.
constexpr scenes::Tolerance kReversedTolerance = {2, 0.003, 1e-5f, "silhouettes of surfaces that intersect"};

gl::Statistics compareFixed(const std::string& name, const Draw& draw) {
  const BothStage stage{.width = kReversedWidth,
                        .height = kReversedHeight,
                        .folder = "reversed",
                        .prepare = [](Gl) {},
                        .tolerance = kReversedTolerance};
  return compareBoth(stage, name, draw);
}

class ReversedDepth : public testing::TestWithParam<Reversal> {};

TEST_P(ReversedDepth, OfFixedFunction) {
  const gl::Statistics s = compareFixed(GetParam().name, [&](Gl gl) { drawLit(gl, GetParam()); });
  EXPECT_EQ(s.drawsRasterised, 0u);
  EXPECT_GT(s.drawsTraced, 0u);
}

TEST_P(ReversedDepth, WithinAScissorBox) {
  const gl::Statistics s = compareFixed(std::string("scissored_") + GetParam().name, [&](Gl gl) {
    gl.Scissor(30, 20, 90, 70);
    gl.Enable(GL_SCISSOR_TEST);
    drawLit(gl, GetParam());
    gl.Disable(GL_SCISSOR_TEST);
  });
  EXPECT_EQ(s.drawsRasterised, 0u);
}

struct ReversedSurface {
  Surface surface{.color = Surface::Color::vertex, .lightCount = 2};
  GLuint program = 0;
  ProgramMesh mesh;
  Upload upload;
};
ReversedSurface readySurface(Gl gl, ProgramMesh mesh) {
  ReversedSurface drawn;
  drawn.program = makeProgram(gl, drawn.surface);
  drawn.mesh = std::move(mesh);
  drawn.upload = upload(gl, drawn.mesh, drawn.program);
  return drawn;
}

View reversedView(const Reversal& r, double degrees) {
  View view = perspectiveView(degrees);
  view.clipFromEye = projected(view.clipFromEye, r);
  return view;
}

void beginReversed(Gl gl, const Reversal& r) {
  gl.ClearDepth(r.clear);
  beginFrame(gl);
  setDepths(gl, r);
}

void drawReversed(Gl gl, const ReversedSurface& drawn, const Reversal& r, double degrees) {
  drawSurface(gl, drawn.program, drawn.upload, drawn.mesh, reversedView(r, degrees), drawn.surface);
}

TEST_P(ReversedDepth, OfShaderPrograms) {
  expectBoth(
      std::string("reversed_") + GetParam().name,
      [&](Gl gl) {
        const ReversedSurface ours = readySurface(gl, ball(20)), sheets = readySurface(gl, sheet(12));
        beginReversed(gl, GetParam());
        drawReversed(gl, ours, GetParam(), 20), drawReversed(gl, sheets, GetParam(), 50),
            drawReversed(gl, sheets, GetParam(), -40);
      },
      3);
}

TEST_P(ReversedDepth, InFramebuffersOfFloatDepths) {
  expectSame(
      std::string("reversed_floats_") + GetParam().name,
      [&](Gl gl) {
        bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, GL_RGBA8, GL_DEPTH_COMPONENT32F);
        const ReversedSurface sheets = readySurface(gl, sheet(12));
        beginReversed(gl, GetParam());
        drawReversed(gl, sheets, GetParam(), 50), drawReversed(gl, sheets, GetParam(), -40);
      },
      2);
}

TEST_P(ReversedDepth, InMultisampledFramebuffers) {
  // Colours at silhouettes are means of samples.
  constexpr scenes::Tolerance kSamples = {2, 0.01, 1e-5f, "silhouettes: each has a band of mixed pixels"};
  expectSame(
      std::string("reversed_samples_") + GetParam().name,
      [&](Gl gl) {
        const ReversedSurface sheets = readySurface(gl, sheet(12));
        bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24, 4);
        beginReversed(gl, GetParam());
        drawReversed(gl, sheets, GetParam(), 50), drawReversed(gl, sheets, GetParam(), -40);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
      },
      2, {}, kSamples);
}

TEST_P(ReversedDepth, AmongDrawsOfTheRealOpenGl) {
  expectSame(
      std::string("reversed_unknown_") + GetParam().name,
      [&](Gl gl) {
        const GLuint unknown = makeUnknownProgram(gl);
        const ReversedSurface sheets = readySurface(gl, sheet(12));
        const ProgramMesh other = ball(20);
        const Upload up = upload(gl, other, unknown);
        beginReversed(gl, GetParam());
        gl.Disable(GL_BLEND);
        drawReversed(gl, sheets, GetParam(), 50);
        drawByUnknown(gl, unknown, up, other, reversedView(GetParam(), 20));
        drawReversed(gl, sheets, GetParam(), -40);
      },
      2);
}

INSTANTIATE_TEST_SUITE_P(All, ReversedDepth, testing::ValuesIn(kReversals),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(MixedDepthFunctions, FollowTheOrderOfDrawing) {
  const Reversal greater{.name = "", .function = GL_GREATER}, less{.name = "", .function = GL_LESS};
  expectSame(
      "mixed_functions",
      [&](Gl gl) {
        const ReversedSurface ours = readySurface(gl, ball(20)), sheets = readySurface(gl, sheet(12));
        beginReversed(gl, {.name = "", .function = GL_LESS, .clear = 0.83});
        drawReversed(gl, ours, less, 20);
        gl.DepthFunc(GL_GREATER);
        drawReversed(gl, sheets, greater, 50);
        gl.DepthFunc(GL_LEQUAL);
        drawReversed(gl, sheets, less, -40);
        gl.DepthFunc(GL_GEQUAL);
        drawReversed(gl, sheets, greater, 10);
      },
      4);
}

TEST(MixedDepthFunctions, OfTracedAndOtherDraws) {
  const Reversal plain{.name = ""};
  for (const auto& [traced, other] : {std::pair(GL_GREATER, GL_LESS),
                                      {GL_LESS, GL_GREATER},
                                      {GL_GEQUAL, GL_LEQUAL},
                                      {GL_LEQUAL, GL_GEQUAL}})
    for (const bool first : {true, false})
      expectSame(
          "mixed_unknown_" + std::to_string(traced) + std::to_string(first),
          [&, traced = traced, other = other](Gl gl) {
            const GLuint unknown = makeUnknownProgram(gl);
            const ReversedSurface sheets = readySurface(gl, sheet(12));
            const ProgramMesh ball20 = ball(20);
            const Upload up = upload(gl, ball20, unknown);
            beginReversed(gl, {.name = "", .function = static_cast<GLenum>(traced), .clear = 0.83});
            gl.Disable(GL_BLEND);
            if (first) drawReversed(gl, sheets, plain, 50);
            gl.DepthFunc(static_cast<GLenum>(other));
            drawByUnknown(gl, unknown, up, ball20, reversedView(plain, 20));
            gl.DepthFunc(static_cast<GLenum>(traced));
            if (!first) drawReversed(gl, sheets, plain, 50);
          },
          1);
}

TEST(ReversedDepthRefused, WhatItsOrderDoesNotDecide) {
  using Change = void (*)(Gl);
  const std::pair<const char*, Change> changes[] = {
      {"offset", [](Gl gl) { gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(1, 4); }},
      {"mask", [](Gl gl) { gl.DepthMask(GL_FALSE); }},
      {"one_depth", [](Gl gl) { gl.DepthRange(0.5, 0.5); }},
  };
  for (const auto& [name, change] : changes) {
    const auto draw = [&, change = change](Gl gl) {
      const ReversedSurface sheets = readySurface(gl, sheet(12));
      beginReversed(gl, kRange);
      change(gl);
      drawReversed(gl, sheets, kLess, 50), drawReversed(gl, sheets, kLess, -40);
      gl.DepthMask(GL_TRUE), gl.Disable(GL_POLYGON_OFFSET_FILL);
    };
    EXPECT_EQ(expectSame(std::string("reversed_refused_") + name, draw, 0).statistics.drawsRasterised, 2u);
  }
}

DrawnImage litBy(const Reversal& r, const Settings& settings) {
  TracedContext ours({kReversedWidth, kReversedHeight}, settings);
  drawLit(ours.gl(), r);
  ours.gl().Finish();
  EXPECT_GT(ours.context().counts.statistics.drawsTraced, 0u);
  return ours.read();
}

TEST(ReversedDepthWithLight, LooksAsTheOrdinaryPicture) {
  const std::pair<const char*, void (*)(Settings&)> effects[] = {
      {"none", [](Settings&) {}},
      {"ao", [](Settings& s) { s.ao.enabled = true, s.ao.samples = 8; }},
      {"shadows", [](Settings& s) { s.shadows.enabled = true, s.shadows.size = 0; }},
      {"path", [](Settings& s) { s.integrator = LightIntegrator::path, s.path.samples = 4; }},
      {"spp", [](Settings& s) { s.spp = 4; }},
      {"lens", [](Settings& s) { s.camera.aperture = 0.1f, s.camera.focus = 4, s.spp = 16; }},
  };
  for (const auto& [name, change] : effects) {
    Settings settings = TracedContext::tracing();
    change(settings);
    const DrawnImage less = litBy(kLess, settings);
    for (const Reversal& r : {kRange, kReversals[2], kReversals[9]}) {
      const DrawnImage greater = litBy(r, settings);
      size_t different = 0;
      for (size_t i = 0; i < less.colors.size(); ++i) {
        EXPECT_NEAR(greater.depths[i], 1 - less.depths[i], 1e-6f) << name << ' ' << r.name << ' ' << i;
        for (int c = 0; c < 32; c += 8)
          different += std::abs(int(less.colors[i] >> c & 255) - int(greater.colors[i] >> c & 255)) > 1;
      }
      EXPECT_LE(different, less.colors.size() / 1000) << name << ' ' << r.name;
    }
  }
}

}  // namespace
}  // namespace gluray::test
