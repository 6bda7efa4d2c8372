// The settings ground and background in a program's framebuffer: which views get them, and that what the
// program draws itself stays.
#include "tests/reference/engine/quad.h"
#include "tests/support/traced_context.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test {
namespace {

constexpr int kSize = 64;
using Gl = const gl::RealGl&;
using Step = std::function<void(Gl)>;

/// A white level plate about (x, 0.5, 0), lit from above.
void plateAt(Gl gl, float x, float half = 0.5f) {
  gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
  gl.Normal3f(0, 1, 0);
  quad(gl, {x - half, 0.5f, half}, {x + half, 0.5f, half}, {x + half, 0.5f, -half}, {x - half, 0.5f, -half});
  gl.Disable(GL_LIGHTING);
}
void plate(Gl gl) { plateAt(gl, 0); }

/// A red square in the window's upper left quarter, without depth.
void overlay(Gl gl) {
  gl.Disable(GL_DEPTH_TEST);
  gl.MatrixMode(GL_PROJECTION), gl.PushMatrix(), gl.LoadIdentity();
  gl.MatrixMode(GL_MODELVIEW), gl.PushMatrix(), gl.LoadIdentity();
  gl.Color4f(1, 0, 0, 1);
  quad(gl, {-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0});
  gl.MatrixMode(GL_PROJECTION), gl.PopMatrix();
  gl.MatrixMode(GL_MODELVIEW), gl.PopMatrix();
  gl.Enable(GL_DEPTH_TEST);
}

/// The viewer stands at (0, 1.5, 5) and looks down a little.
class Program {
 public:
  explicit Program(const Settings& settings) : context_({kSize, kSize}, settings) {
    const GLfloat none[] = {0, 0, 0, 1}, white[] = {1, 1, 1, 1};
    gl().Enable(GL_DEPTH_TEST);
    gl().LightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    gl().Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
    gl().MatrixMode(GL_PROJECTION);
    const glm::mat4 lens = glm::perspective(glm::radians(40.0f), 1.0f, 4.0f, 6.0f);
    gl().LoadMatrixf(glm::value_ptr(lens));
    gl().MatrixMode(GL_MODELVIEW);
  }
  Gl gl() const { return context_.gl(); }
  Picture frame(const std::vector<Step>& steps, const glm::vec4& clear = {0, 0, 1, 1}, float turn = 0) {
    context_.makeCurrent();
    const glm::mat4 tilted = glm::rotate(glm::mat4(1), glm::radians(15.0f), {1, 0, 0});
    const glm::mat4 camera =
        glm::rotate(glm::translate(tilted, {0, -1.5f, -5}), glm::radians(turn), {0, 1, 0});
    const GLfloat above[] = {0, 1, 0, 0};
    gl().LoadMatrixf(glm::value_ptr(camera));
    gl().Lightfv(GL_LIGHT0, GL_POSITION, above);
    gl().Viewport(0, 0, kSize, kSize);
    gl().ClearColor(clear.r, clear.g, clear.b, clear.a);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const Step& step : steps) step(gl());
    gl().Finish();
    return context_.read();
  }
  const gl::Statistics& statistics() const { return context_.context().counts.statistics; }

 private:
  TracedContext context_;
};

Settings with(GroundKind ground, BackgroundKind background = BackgroundKind::program) {
  Settings settings = TracedContext::tracing();
  settings.ground.kind = ground;
  settings.ground.offset = 0.3f;
  settings.background.kind = background;
  settings.background.color = {0, 1, 0};
  return settings;
}

uint32_t at(const Picture& picture, int x, int y) {
  return picture.colors[static_cast<size_t>(y * kSize + x)];
}
int red(uint32_t color) { return static_cast<int>(color & 255); }

constexpr uint32_t kBlue = 0xffff0000, kGreen = 0xff00ff00, kRed = 0xff0000ff;

TEST(GroundInPrograms, FillsTheViewBelowTheScene) {
  const Picture without = Program(with(GroundKind::off)).frame({plate}),
                with = Program(test::with(GroundKind::plane)).frame({plate});
  EXPECT_EQ(at(without, 5, 5), kBlue);
  for (const int x : {2, 32, 61}) EXPECT_NEAR(red(at(with, x, 3)), 204, 2) << x;
  int seen = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if (at(without, x, y) != kBlue) {
        EXPECT_EQ(at(with, x, y), at(without, x, y)) << x << ' ' << y;
        ++seen;
      }
  EXPECT_GT(seen, 30) << "the plate stays as it is";
}

TEST(GroundInPrograms, ALayerOverTheSceneAndAnInsetHaveNone) {
  const Step layer = [](Gl gl) { gl.Clear(GL_DEPTH_BUFFER_BIT), plateAt(gl, 0.9f, 0.1f); };
  const Picture one = Program(with(GroundKind::plane)).frame({plate}),
                two = Program(with(GroundKind::plane)).frame({plate, layer});
  int same = 0;
  for (size_t i = 0; i < one.colors.size(); ++i) same += one.colors[i] == two.colors[i];
  EXPECT_GT(same, kSize * kSize - 60) << "all but the small plate";
  EXPECT_LT(same, kSize * kSize);
  const Step inset = [](Gl gl) {
    gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, 16, 16), gl.Viewport(0, 0, 16, 16);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    plate(gl);
    gl.Disable(GL_SCISSOR_TEST);
  };
  const Picture marked = Program(with(GroundKind::plane)).frame({plate, inset});
  EXPECT_EQ(at(marked, 1, 1), kBlue);
  EXPECT_NEAR(red(at(marked, 20, 1)), 204, 2);
}

TEST(GroundInPrograms, SeveralBatchesOfAViewShowOne) {
  const Step flushed = [](Gl gl) {
    uint32_t pixel = 0;
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    plateAt(gl, 1.2f, 0.2f);
  };
  Program program(with(GroundKind::plane));
  program.frame({plate, flushed});
  const Picture picture = program.frame({plate, flushed});
  Program whole(with(GroundKind::plane));
  const Picture expected = whole.frame({plate, [](Gl gl) { plateAt(gl, 1.2f, 0.2f); }});
  int differ = 0;
  for (size_t i = 0; i < picture.colors.size(); ++i) differ += picture.colors[i] != expected.colors[i];
  EXPECT_LE(differ, 4) << "the second frame knows the bounds of both";
}

TEST(GroundInPrograms, PicturesToPickFromHaveNone) {
  const Step flat = [](Gl gl) {
    gl.Color3ub(7, 0, 0), quad(gl, {-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0});
  };
  const Picture picture = Program(with(GroundKind::plane, BackgroundKind::color)).frame({flat}, {0, 0, 0, 0});
  EXPECT_EQ(at(picture, 5, 3), 0u);
}

TEST(GroundInPrograms, MovingTheCameraBuildsNothing) {
  Program program(with(GroundKind::plane));
  program.frame({plate});
  program.frame({plate}, {0, 0, 1, 1}, 5);
  const uint64_t before = program.statistics().blasBuilds;
  for (int i = 2; i < 12; ++i) program.frame({plate}, {0, 0, 1, 1}, 5.0f * static_cast<float>(i));
  EXPECT_EQ(program.statistics().blasBuilds, before);
}

TEST(CatcherInPrograms, DarkensTheBackgroundAndKeepsTheShadowInAlpha) {
  Settings settings = with(GroundKind::catcher);
  settings.shadows.enabled = true;
  settings.shadows.size = 0;
  settings.shadows.strength = 0.5f;
  const Picture white = Program(settings).frame({plate}, {1, 1, 1, 1}),
                clear = Program(settings).frame({plate}, {0, 0, 0, 0});
  int shadow = 0, open = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const uint32_t alpha = at(clear, x, y) >> 24;
      if (white.depths[static_cast<size_t>(y * kSize + x)] < 1) continue;  // the plate
      EXPECT_NEAR(red(at(white, x, y)), 255 - static_cast<int>(alpha), 1) << x << ' ' << y;
      EXPECT_EQ(at(white, x, y) >> 24, 255u);
      EXPECT_EQ(at(clear, x, y) & 0xffffff, 0u);
      shadow += alpha == 127 || alpha == 128;
      open += alpha == 0;
    }
  }
  EXPECT_GT(shadow, 20);
  EXPECT_GT(open, 1000);
}

TEST(BackgroundInPrograms, ReplacesTheClearColourAlone) {
  const Picture picture = Program(with(GroundKind::off, BackgroundKind::color)).frame({overlay, plate});
  const Picture before = Program(with(GroundKind::off)).frame({overlay, plate});
  int red = 0, green = 0;
  for (size_t i = 0; i < picture.colors.size(); ++i) {
    EXPECT_EQ(picture.depths[i], before.depths[i]);
    EXPECT_EQ(picture.colors[i], before.colors[i] == kBlue ? kGreen : before.colors[i]);
    red += picture.colors[i] == kRed, green += picture.colors[i] == kGreen;
  }
  EXPECT_GT(red, 900);
  EXPECT_GT(green, 1000);
}

TEST(BackgroundInPrograms, OverlaysDrawnLaterStay) {
  const Picture picture = Program(with(GroundKind::off, BackgroundKind::color)).frame({plate, overlay});
  EXPECT_EQ(at(picture, 5, 60), kRed);
  EXPECT_EQ(at(picture, 60, 60), kGreen);
}

TEST(BackgroundInPrograms, AProgramsOwnBackgroundStays) {
  const Step own = [](Gl gl) {
    overlay(gl);
    gl.Disable(GL_DEPTH_TEST);
    gl.PushMatrix(), gl.LoadIdentity(), gl.MatrixMode(GL_PROJECTION), gl.PushMatrix(), gl.LoadIdentity();
    quad(gl, {-1, -0.9f, 0}, {1, -0.9f, 0}, {1, 1, 0}, {-1, 1, 0});
    gl.PopMatrix(), gl.MatrixMode(GL_MODELVIEW), gl.PopMatrix();
    gl.Enable(GL_DEPTH_TEST);
  };
  const Picture picture = Program(with(GroundKind::off, BackgroundKind::color)).frame({own, plate});
  EXPECT_EQ(at(picture, 60, 0), kBlue);
}

}  // namespace
}  // namespace gluray::test
