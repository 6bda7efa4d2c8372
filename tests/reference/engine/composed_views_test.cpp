// A rank of an MPI program reads its image, composes it with others, and draws the result over a background
// (adr/0089): where the image is recognised, the framebuffer is that of one process; elsewhere it is what
// the program has drawn.
#include "frame/testing/test_renderer.h"
#include "intercept/present/tracing_presenter.h"
#include "tests/reference/engine/quad.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/traced_context.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

constexpr int kComposedSize = 64;
using Gl = const gl::RealGl&;
using Pixels = std::vector<uint32_t>;
const glm::vec4 kEmpty{0}, kBackground{0.2f, 0.4f, 0.6f, 0};

/// A lit white plate about (x, y, 0).
void cardAt(Gl gl, float x, float y, float half = 0.4f) {
  gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0), gl.Normal3f(0, 1, 0);
  quad(gl, {x - half, y, half}, {x + half, y, half}, {x + half, y, -half}, {x - half, y, -half});
  gl.Disable(GL_LIGHTING);
}

/// What the ranks' data are: two batches, because the second one is offset.
void drawData(Gl gl) {
  cardAt(gl, -0.7f, 0.3f);
  gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(1, 1);
  cardAt(gl, 0.6f, 0.6f, 0.3f);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
}

/// A square of this size at the lower left corner of the window.
void plainSquare(Gl gl, float size) {
  gl.Disable(GL_DEPTH_TEST);
  for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW})
    gl.MatrixMode(mode), gl.PushMatrix(), gl.LoadIdentity();
  gl.Begin(GL_QUADS);
  for (const glm::vec2& at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
    gl.TexCoord2f(at.x, at.y), gl.Vertex3f(at.x * size - 1, at.y * size - 1, 0);
  gl.End();
  for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) gl.MatrixMode(mode), gl.PopMatrix();
  gl.Enable(GL_DEPTH_TEST);
}

/// Draws pixels over the window, premultiplied.
void drawComposed(Gl gl, const Pixels& pixels) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture), gl.BindTexture(GL_TEXTURE_2D, texture);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kComposedSize, kComposedSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                pixels.data());
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D), gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  plainSquare(gl, 2);
  gl.Disable(GL_TEXTURE_2D), gl.Disable(GL_BLEND);
  gl.DeleteTextures(1, &texture);
}

/// A rank that gathers: its tracer leaves ground and background out, and can trace them.
struct Rank {
  int leftOut = 0, completed = 0;
  frame::Tracer tracer() {
    frame::Tracer tracer;
    tracer.trace = [](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error) {
      scene::Snapshot without = s;
      without.ground = scene::GroundUse::none, without.backdrop = nullptr;
      return testRenderer().render(without, image, cost, error);
    };
    tracer.standsAlone = [](const scene::Snapshot&) { return false; };
    tracer.shown = [](const scene::Snapshot&, const Image&, bool) {};
    tracer.scenery = {
        [](const scene::Snapshot&) { return true; },
        [this](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error) {
          ++completed;
          return testRenderer().render(s, image, cost, error);
        },
        [this] { ++leftOut; }};
    return tracer;
  }
};

class ComposingProgram {
 public:
  explicit ComposingProgram(const Settings& settings, Rank* rank = nullptr)
      : context_({kComposedSize, kComposedSize}, settings,
                 rank ? std::make_unique<present::TracingPresenter>(rank->tracer()) : nullptr) {
    bindNewFramebuffer(gl(), {kComposedSize, kComposedSize}, GL_RGBA8, GL_DEPTH_COMPONENT24);
    gl().Viewport(0, 0, kComposedSize, kComposedSize);
    const GLfloat none[] = {0, 0, 0, 1}, white[] = {1, 1, 1, 1}, above[] = {0, 1, 0, 0};
    gl().Enable(GL_DEPTH_TEST), gl().DepthFunc(GL_LEQUAL);
    gl().LightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    gl().Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
    gl().MatrixMode(GL_PROJECTION);
    const glm::mat4 lens = glm::perspective(glm::radians(40.0f), 1.0f, 3.0f, 8.0f);
    gl().LoadMatrixf(glm::value_ptr(lens));
    gl().MatrixMode(GL_MODELVIEW);
    const glm::mat4 camera =
        glm::translate(glm::rotate(glm::mat4(1), glm::radians(15.0f), {1, 0, 0}), {0, -1.5f, -5});
    gl().LoadMatrixf(glm::value_ptr(camera));
    gl().Lightfv(GL_LIGHT0, GL_POSITION, above);
  }
  Gl gl() const { return context_.gl(); }
  void clear(const glm::vec4& color) {
    gl().ClearColor(color.r, color.g, color.b, color.a);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  /// Draws the data as a rank does, and reads them.
  Pixels draw() {
    clear(kEmpty), drawData(gl());
    return context_.read().colors;
  }
  DrawnImage read() const { return context_.read(); }
  void makeCurrent() { context_.makeCurrent(); }

 private:
  TracedContext context_;
};

Settings settingsOf(GroundKind ground) {
  Settings settings = TracedContext::tracing();
  settings.gather = true;
  settings.ground.kind = ground, settings.ground.offset = 0.2f;
  settings.ao.enabled = true, settings.ao.samples = 4, settings.refine.passes = 1;
  return settings;
}

struct ComposedCase {
  const char* name;
  std::function<void(Settings&)> change;
};
class ComposedViewsTest : public testing::TestWithParam<ComposedCase> {};

TEST_P(ComposedViewsTest, AreThoseOfOneProcess) {
  Settings settings = settingsOf(GroundKind::plane);
  GetParam().change(settings);
  constexpr size_t kFrames = 3;
  std::vector<DrawnImage> one;
  {
    ComposingProgram program(settings);
    while (one.size() < kFrames)
      program.clear(kBackground), drawData(program.gl()), one.push_back(program.read());
  }
  Rank rank;
  ComposingProgram program(settings, &rank);
  for (size_t frame = 0; frame < kFrames; ++frame) {
    const DrawnImage& expected = one[frame];
    const Pixels composed = program.draw();
    EXPECT_NE(composed, expected.colors);
    program.clear(kBackground), drawComposed(program.gl(), composed);
    const DrawnImage got = program.read();
    // Images that wait for other ranks are not lit again: they know the second plate from the second frame
    // on.
    EXPECT_TRUE(frame == 0 || got.colors == expected.colors) << frame;
    EXPECT_EQ(got.depths, expected.depths) << frame;
    EXPECT_EQ(program.gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
  EXPECT_EQ(rank.leftOut, 0);
}

INSTANTIATE_TEST_SUITE_P(
    All, ComposedViewsTest,
    testing::Values(ComposedCase{"Ground", [](Settings&) {}},
                    ComposedCase{"GroundInFront", [](Settings& s) { s.ground.offset = -0.9f; }},
                    ComposedCase{"Catcher", [](Settings& s) { s.ground.kind = GroundKind::catcher; }},
                    ComposedCase{"Background",
                                 [](Settings& s) {
                                   s.ground.kind = GroundKind::off;
                                   s.background.kind = BackgroundKind::gradient;
                                 }},
                    ComposedCase{"Averages", [](Settings& s) { s.spp = 4; }},
                    ComposedCase{"AveragesAlone",
                                 [](Settings& s) { s.spp = 4, s.ground.kind = GroundKind::off; }},
                    ComposedCase{"Paths",
                                 [](Settings& s) {
                                   s.integrator = LightIntegrator::path, s.path.samples = 2;
                                   s.background.kind = BackgroundKind::environment;
                                 }}),
    [](const auto& info) { return std::string(info.param.name); });

/// A background that the program draws itself stays where no ground is.
TEST(ComposedViews, OverABackgroundOfTheProgram) {
  const Settings settings = settingsOf(GroundKind::plane);
  const auto background = [](ComposingProgram& program) {
    program.clear(kBackground), program.gl().Color4f(1, 0, 0, 1), plainSquare(program.gl(), 1.7f);
  };
  ComposingProgram one(settings);
  background(one), drawData(one.gl());
  const Pixels expected = one.read().colors;
  Rank rank;
  ComposingProgram program(settings, &rank);
  const Pixels composed = program.draw();
  background(program), drawComposed(program.gl(), composed);
  EXPECT_EQ(program.read().colors, expected);
  EXPECT_EQ(rank.leftOut, 0);
}

/// The program's image, as the real OpenGL draws it.
Pixels drawnOver(const Pixels& composed, const glm::vec4& background) {
  Settings off = settingsOf(GroundKind::off);
  ComposingProgram plain(off);
  plain.clear(background), drawComposed(plain.gl(), composed);
  return plain.read().colors;
}

TEST(ComposedViews, OtherImagesStayAsTheyAreDrawn) {
  const Settings settings = settingsOf(GroundKind::plane);
  const std::function<void(Pixels&)> changes[] = {
      [](Pixels& p) { p[5] = 0xff00ff00; },                 // something that another rank has drawn
      [](Pixels& p) { p.assign(p.size(), 0); },             // nothing
      [](Pixels& p) { std::reverse(p.begin(), p.end()); },  // another image
      [](Pixels& p) {                                       // without a surface
        for (uint32_t& pixel : p)
          if (pixel != 0) pixel = 0, p.back() = 0;
      }};
  for (const auto& change : changes) {
    Rank rank;
    ComposingProgram program(settings, &rank);
    Pixels composed = program.draw();
    change(composed);
    program.clear(kBackground), drawComposed(program.gl(), composed);
    const Pixels got = program.read().colors;
    EXPECT_EQ(got, drawnOver(composed, kBackground));
    program.makeCurrent(), program.draw();
    EXPECT_GT(rank.leftOut, 0);
  }
}

TEST(ComposedViews, WhatTheRankDrawsBesideTracedSurfacesStays) {
  const Settings settings = settingsOf(GroundKind::plane);
  for (const bool first : {false, true}) {
    Rank rank;
    ComposingProgram program(settings, &rank);
    const auto mark = [&] { program.gl().Color4f(1, 0, 0, 1), plainSquare(program.gl(), 0.2f); };
    program.clear(kEmpty);
    if (first) mark();
    drawData(program.gl());
    if (!first) mark();
    const Pixels composed = program.read().colors;
    program.clear(kBackground), drawComposed(program.gl(), composed);
    const Pixels got = program.read().colors;
    EXPECT_EQ(got, drawnOver(composed, kBackground)) << first;
  }
}

TEST(ComposedViews, BackgroundOfTheProgramIsNotReplacedInPart) {
  Settings settings = settingsOf(GroundKind::plane);
  settings.background.kind = BackgroundKind::color;
  Rank rank;
  ComposingProgram program(settings, &rank);
  const Pixels composed = program.draw();
  program.clear(kBackground), program.gl().Color4f(1, 0, 0, 1), plainSquare(program.gl(), 1.7f);
  const Pixels before = program.read().colors;
  drawComposed(program.gl(), composed);
  const Pixels after = program.read().colors;
  for (size_t i = 0; i < after.size(); ++i)
    EXPECT_EQ(after[i], composed[i] >> 24 == 0 ? before[i] : composed[i]) << i;
}

TEST(ComposedViews, ImagesThatNobodyShowsAreNotMadeForEver) {
  Rank rank;
  ComposingProgram program(settingsOf(GroundKind::plane), &rank);
  for (int frame = 0; frame < 40; ++frame) program.draw();
  EXPECT_LT(rank.completed, 20) << "of 80 batches";
  EXPECT_GT(rank.leftOut, 0);
}

TEST(ComposedViews, ErrorsOfTheProgramStay) {
  Rank rank;
  ComposingProgram program(settingsOf(GroundKind::plane), &rank);
  const Pixels composed = program.draw();
  program.clear(kBackground);
  program.gl().Enable(0xdead);
  drawComposed(program.gl(), composed);
  EXPECT_EQ(program.gl().GetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_EQ(program.gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace gluray::test
