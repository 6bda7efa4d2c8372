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

constexpr int kGroundSize = 64;
using Gl = const gl::RealGl&;
using GroundStep = std::function<void(Gl)>;

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
class GroundProgram {
 public:
  explicit GroundProgram(const Settings& settings) : context_({kGroundSize, kGroundSize}, settings) {
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
  DrawnImage frame(const std::vector<GroundStep>& steps, const glm::vec4& clear = {0, 0, 1, 1},
                   float turn = 0) {
    context_.makeCurrent();
    const glm::mat4 tilted = glm::rotate(glm::mat4(1), glm::radians(15.0f), {1, 0, 0});
    const glm::mat4 camera =
        glm::rotate(glm::translate(tilted, {0, -1.5f, -5}), glm::radians(turn), {0, 1, 0});
    const GLfloat above[] = {0, 1, 0, 0};
    gl().LoadMatrixf(glm::value_ptr(camera));
    gl().Lightfv(GL_LIGHT0, GL_POSITION, above);
    gl().Viewport(0, 0, kGroundSize, kGroundSize);
    gl().ClearColor(clear.r, clear.g, clear.b, clear.a);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const GroundStep& step : steps) step(gl());
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

uint32_t at(const DrawnImage& image, int x, int y) {
  return image.colors[static_cast<size_t>(y * kGroundSize + x)];
}
int red(uint32_t color) { return static_cast<int>(color & 255); }

constexpr uint32_t kBluePixel = 0xffff0000, kGreenPixel = 0xff00ff00, kRedPixel = 0xff0000ff;

TEST(GroundInPrograms, FillsTheViewBelowTheScene) {
  const DrawnImage without = GroundProgram(with(GroundKind::off)).frame({plate}),
                   with = GroundProgram(test::with(GroundKind::plane)).frame({plate});
  EXPECT_EQ(at(without, 5, 5), kBluePixel);
  for (const int x : {2, 32, 61}) EXPECT_NEAR(red(at(with, x, 3)), 204, 2) << x;
  int seen = 0;
  for (int y = 0; y < kGroundSize; ++y)
    for (int x = 0; x < kGroundSize; ++x)
      if (at(without, x, y) != kBluePixel) {
        EXPECT_EQ(at(with, x, y), at(without, x, y)) << x << ' ' << y;
        ++seen;
      }
  EXPECT_GT(seen, 30) << "the plate stays as it is";
}

TEST(GroundInPrograms, ALayerOverTheSceneAndAnInsetHaveNone) {
  const GroundStep layer = [](Gl gl) { gl.Clear(GL_DEPTH_BUFFER_BIT), plateAt(gl, 0.9f, 0.1f); };
  const DrawnImage one = GroundProgram(with(GroundKind::plane)).frame({plate}),
                   two = GroundProgram(with(GroundKind::plane)).frame({plate, layer});
  int same = 0;
  for (size_t i = 0; i < one.colors.size(); ++i) same += one.colors[i] == two.colors[i];
  EXPECT_GT(same, kGroundSize * kGroundSize - 60) << "all but the small plate";
  EXPECT_LT(same, kGroundSize * kGroundSize);
  const GroundStep inset = [](Gl gl) {
    gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, 16, 16), gl.Viewport(0, 0, 16, 16);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    plate(gl);
    gl.Disable(GL_SCISSOR_TEST);
  };
  const DrawnImage marked = GroundProgram(with(GroundKind::plane)).frame({plate, inset});
  EXPECT_EQ(at(marked, 1, 1), kBluePixel);
  EXPECT_NEAR(red(at(marked, 20, 1)), 204, 2);
}

TEST(GroundInPrograms, SeveralBatchesOfAViewShowOne) {
  const GroundStep flushed = [](Gl gl) {
    uint32_t pixel = 0;
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    plateAt(gl, 1.2f, 0.2f);
  };
  GroundProgram program(with(GroundKind::plane));
  program.frame({plate, flushed});
  const DrawnImage image = program.frame({plate, flushed});
  GroundProgram whole(with(GroundKind::plane));
  const DrawnImage expected = whole.frame({plate, [](Gl gl) { plateAt(gl, 1.2f, 0.2f); }});
  int differ = 0;
  for (size_t i = 0; i < image.colors.size(); ++i) differ += image.colors[i] != expected.colors[i];
  EXPECT_LE(differ, 4) << "the second frame knows the bounds of both";
}

TEST(GroundInPrograms, ImagesToPickFromHaveNone) {
  const GroundStep flat = [](Gl gl) {
    gl.Color3ub(7, 0, 0), quad(gl, {-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0});
  };
  const DrawnImage image =
      GroundProgram(with(GroundKind::plane, BackgroundKind::color)).frame({flat}, {0, 0, 0, 0});
  EXPECT_EQ(at(image, 5, 3), 0u);
}

TEST(GroundInPrograms, MovingTheCameraBuildsNothing) {
  GroundProgram program(with(GroundKind::plane));
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
  const DrawnImage white = GroundProgram(settings).frame({plate}, {1, 1, 1, 1}),
                   clear = GroundProgram(settings).frame({plate}, {0, 0, 0, 0});
  int shadow = 0, open = 0;
  for (int y = 0; y < kGroundSize; ++y) {
    for (int x = 0; x < kGroundSize; ++x) {
      const uint32_t alpha = at(clear, x, y) >> 24;
      if (white.depths[static_cast<size_t>(y * kGroundSize + x)] < 1) continue;  // the plate
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
  const DrawnImage image =
      GroundProgram(with(GroundKind::off, BackgroundKind::color)).frame({overlay, plate});
  const DrawnImage before = GroundProgram(with(GroundKind::off)).frame({overlay, plate});
  int red = 0, green = 0;
  for (size_t i = 0; i < image.colors.size(); ++i) {
    EXPECT_EQ(image.depths[i], before.depths[i]);
    EXPECT_EQ(image.colors[i], before.colors[i] == kBluePixel ? kGreenPixel : before.colors[i]);
    red += image.colors[i] == kRedPixel, green += image.colors[i] == kGreenPixel;
  }
  EXPECT_GT(red, 900);
  EXPECT_GT(green, 1000);
}

TEST(BackgroundInPrograms, OverlaysDrawnLaterStay) {
  const DrawnImage image =
      GroundProgram(with(GroundKind::off, BackgroundKind::color)).frame({plate, overlay});
  EXPECT_EQ(at(image, 5, 60), kRedPixel);
  EXPECT_EQ(at(image, 60, 60), kGreenPixel);
}

TEST(BackgroundInPrograms, AProgramsOwnBackgroundStays) {
  const GroundStep own = [](Gl gl) {
    overlay(gl);
    gl.Disable(GL_DEPTH_TEST);
    gl.PushMatrix(), gl.LoadIdentity(), gl.MatrixMode(GL_PROJECTION), gl.PushMatrix(), gl.LoadIdentity();
    quad(gl, {-1, -0.9f, 0}, {1, -0.9f, 0}, {1, 1, 0}, {-1, 1, 0});
    gl.PopMatrix(), gl.MatrixMode(GL_MODELVIEW), gl.PopMatrix();
    gl.Enable(GL_DEPTH_TEST);
  };
  const DrawnImage image = GroundProgram(with(GroundKind::off, BackgroundKind::color)).frame({own, plate});
  EXPECT_EQ(at(image, 60, 0), kBluePixel);
}

}  // namespace
}  // namespace gluray::test
