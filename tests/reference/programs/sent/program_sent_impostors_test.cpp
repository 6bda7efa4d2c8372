// Impostors whose billboards the program sends: what the program computes is what is traced.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/sent/sent_impostors.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

struct SentCase {
  const char* name;
  bool sticks = false, parallel = false, roundCaps = true;
  float scale = 1, blend = 0;
  bool cull = false;
};
void PrintTo(const SentCase& c, std::ostream* out) { *out << c.name; }

const SentCase kSentCases[] = {
    {"spheres"},
    {"spheres_parallel", false, true},
    {"spheres_scaled", false, false, true, 2.5f},
    {"sticks", true},
    {"sticks_parallel", true, true},
    {"sticks_scaled", true, false, true, 0.5f, 0.05f},
    {"sticks_not_scaled", true, false, true, 0},
    {"sticks_flat", true, false, false, 1.5f},
    {"sticks_blended", true, true, true, 2, 0.1f},
    {"sticks_culled", true, false, true, 1, 0, true},
};

SentView lookOf(const SentCase& c) {
  return {c.parallel ? parallelView(35) : perspectiveView(35), c.parallel, c.scale, c.roundCaps, c.blend};
}

class SentBillboards : public testing::TestWithParam<SentCase> {};

TEST_P(SentBillboards, AreWhatTheProgramComputes) {
  const SentCase& c = GetParam();
  const SentImpostors sent = c.sticks ? manySticks() : manySpheres();
  expectBoth(
      std::string("sent_") + c.name,
      [&](Gl gl) {
        prepareSent(gl, sent, lookOf(c));
        if (c.cull) gl.Enable(GL_CULL_FACE);
        drawSent(gl, sent);
      },
      1, {}, kProgramTolerance, sentFamily(c.sticks, c.parallel));
}

INSTANTIATE_TEST_SUITE_P(Cases, SentBillboards, testing::ValuesIn(kSentCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// A view of the same things from `distance`, scaled by `scale`, between near planes at 1 and 10.
View viewFrom(double distance, double scale) {
  View view = perspectiveView(35);
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.6, glm::dvec3(1, 2, 0.5));
  view.eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, -distance}) * turned *
                       glm::scale(glm::dmat4(1), glm::dvec3(scale));
  return view;
}

TEST(SentBillboard, SpheresReachThroughTheNearAndTheFarPlane) {
  const SentImpostors sent = manySpheres();
  for (const double distance : {1.6, 10.0})
    expectBoth(
        "sent_spheres_from_" + std::to_string(static_cast<int>(distance)),
        [&](Gl gl) {
          SentView look;
          look.view = viewFrom(distance, 1.0), look.scale = 3;
          prepareSent(gl, sent, look), drawSent(gl, sent);
        },
        1, {}, kProgramTolerance, sentFamily(false, false));
}

// Seen from near, squares of spheres cut a part of them off.
TEST(SentBillboard, LargeSpheresAreCutByTheirSquares) {
  SentImpostors sent;
  sent.addSphere({1.7f, 0.9f, -2.6f}, 1.4f, {1, 0.5f, 0.2f});
  sent.addSphere({-1.2f, -0.3f, -2.2f}, 1.1f, {0.3f, 0.6f, 1});
  expectBoth(
      "sent_large_spheres",
      [&](Gl gl) {
        SentView look;
        look.view.clipFromEye = glm::perspective(glm::radians(80.0), 4.0 / 3, 0.2, 10.0);
        look.view.eyeFromObject = glm::dmat4(1);
        prepareSent(gl, sent, look), drawSent(gl, sent);
      },
      1, {}, kProgramTolerance, sentFamily(false, false));
}

TEST(SentBillboard, SticksReachThroughTheNearAndTheFarPlane) {
  const SentImpostors sent = manySticks();
  for (const double distance : {1.9, 10.0})
    expectBoth(
        "sent_sticks_from_" + std::to_string(static_cast<int>(distance)),
        [&](Gl gl) {
          SentView look;
          look.view = viewFrom(distance, 0.8), look.scale = 2;
          prepareSent(gl, sent, look), drawSent(gl, sent);
        },
        1, {}, kProgramTolerance, sentFamily(true, false));
}

TEST(SentBillboard, RadiiGrowWithTheModelsScale) {
  const SentImpostors sent = manySticks();
  expectBoth(
      "sent_sticks_grown",
      [&](Gl gl) {
        SentView look;
        look.view = viewFrom(6, 1.6);
        prepareSent(gl, sent, look), drawSent(gl, sent);
      },
      1, {}, kProgramTolerance, sentFamily(true, false));
}

TEST(SentBillboard, QuadsAreBillboardsToo) {
  const SentImpostors sent = manySpheres();
  expectBoth(
      "sent_quads",
      [&](Gl gl) {
        prepareSent(gl, sent, {});
        std::vector<GLushort> numbers;
        for (size_t i = 0; i < sent.numbers.size(); i += 6)
          for (const size_t k : {0, 1, 2, 5}) numbers.push_back(sent.numbers[i + k]);
        drawNumbered(gl, GL_QUADS, numbers);
      },
      1, {kProgramWidth, kProgramHeight}, kProgramTolerance, sentFamily(false, false));
}

TEST(SentBillboard, SpheresAreComputedOnceAPixelWithFourSamplesAndSticksLeft) {
  for (const bool sticks : {false, true}) {
    const SentImpostors sent = sticks ? manySticks() : manySpheres();
    expectBoth(
        sticks ? "sent_sticks_4x" : "sent_spheres_4x",
        [&](Gl gl) {
          const glm::ivec2 size(kProgramWidth, kProgramHeight);
          bindNewFramebuffer(gl, size, GL_RGBA8, GL_DEPTH24_STENCIL8, 4);
          prepareSent(gl, sent, {}), drawSent(gl, sent);
          gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
          gl.BlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
          gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        },
        sticks ? 0 : 1, {}, kProgramTolerance, sentFamily(sticks, false));
  }
}

TEST(SentBillboard, TheViewerTurnsAndNothingIsBuilt) {
  const SentImpostors sent = manySticks();
  const Outcome outcome = expectSame(
      "sent_sticks_turned",
      [&](Gl gl) {
        prepareSent(gl, sent, {});
        GLint program = 0;
        gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
        for (int i = 0; i < 3; ++i) {
          const View view = perspectiveView(35 + 20 * i);
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          setMat4(gl, static_cast<GLuint>(program), "modelview", glm::mat4(view.eyeFromObject));
          setMat3(gl, static_cast<GLuint>(program), "turn",
                  glm::mat3(glm::transpose(glm::inverse(glm::dmat3(view.eyeFromObject)))));
          if (i == 0) drawSent(gl, sent);
          if (i > 0)
            gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(sent.numbers.size()), GL_UNSIGNED_SHORT,
                            nullptr);
        }
      },
      3, {}, kProgramTolerance, sentFamily(true, false));
  EXPECT_EQ(outcome.statistics.meshesBuilt, 1u);
}

}  // namespace
}  // namespace gluray::test
