// Impostors whose billboards the program sends: what is left to the real OpenGL.
#include "tests/reference/programs/sent/sent_impostors.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <functional>

namespace gluray::test {
namespace {

void expectRefused(
    const std::string& name, const SentImpostors& sent, const SentView& look,
    const std::function<void(Gl)>& change = [](Gl) {}) {
  expectSame(
      "sent_refused_" + name,
      [&](Gl gl) {
        prepareSent(gl, sent, look);
        change(gl);
        drawSent(gl, sent);
      },
      0, {}, kProgramTolerance, sentFamily(sent.sticks, look.parallel));
}

TEST(SentRefused, BillboardsWhoseCornersDisagree) {
  SentImpostors spheres = manySpheres();
  spheres.places[10].x += 0.2f;
  expectRefused("sphere", spheres, {});
  SentImpostors sticks = manySticks();
  sticks.tips[100].z += 0.1f;
  expectRefused("stick", sticks, {});
  sticks = manySticks();
  sticks.caps[8] = 40;
  expectRefused("caps", sticks, {});
}

TEST(SentRefused, BillboardsInPartsAndOfVerticesThatDoNotExist) {
  SentImpostors sticks = manySticks();
  sticks.numbers.resize(sticks.numbers.size() - 3);
  expectRefused("part", sticks, {});
  sticks = manySticks();
  std::swap(sticks.numbers[36], sticks.numbers[37]);
  expectRefused("turned", sticks, {});
  SentImpostors spheres = manySpheres();
  spheres.numbers[7] = 40000;
  expectRefused("beyond", spheres, {});
}

TEST(SentRefused, SticksAroundTheViewer) {
  SentView look;
  look.view.eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, 0.3}) * look.view.eyeFromObject;
  look.view.eyeFromObject[3] = {0, 0, 0, 1};
  expectRefused("around", manySticks(), look);
}

TEST(SentRefused, SticksAlongAParallelView) {
  SentImpostors sticks;
  sticks.addStick({0, 0, -1}, {0, 0, 1}, 0.3f, 15, {1, 0, 0}, {0, 1, 0});
  SentView look;
  look.parallel = true, look.view = parallelView();
  look.view.eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, -4});
  expectRefused("along", sticks, look);  // what the program computes there is undefined
}

TEST(SentRefused, MatricesThatStretchAndOtherProjections) {
  SentView look;
  look.view.eyeFromObject = look.view.eyeFromObject * glm::scale(glm::dmat4(1), {1, 2, 1});
  expectRefused("stretched", manySticks(), look);
  SentView other;
  other.view.clipFromEye = parallelView().clipFromEye;
  expectRefused("projection", manySpheres(), other);
  SentView none;
  none.scale = 0;
  expectRefused("scale", manySpheres(), none);
}

TEST(SentRefused, StateThatTheProgramDoesNotExpect) {
  expectRefused("culled", manySpheres(), {}, [](Gl gl) { gl.Enable(GL_CULL_FACE), gl.FrontFace(GL_CW); });
  expectRefused("depth_range", manySpheres(), {}, [](Gl gl) { gl.DepthRange(0, 0.5); });
  SentView far;
  far.view.eyeFromObject =
      glm::translate(glm::dmat4(1), {0, 0, -10}) * glm::dmat4(glm::dmat3(far.view.eyeFromObject));
  expectRefused("beyond_far", manySticks(), far, [](Gl gl) { gl.DepthFunc(GL_LEQUAL); });
}

}  // namespace
}  // namespace gluray::test
