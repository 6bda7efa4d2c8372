// Pictures of saved scenes from other sides.
#include "saved/shot/turned_view.h"

#include "render/testing/lit_wall.h"
#include "render/testing/test_ball.h"
#include "saved/testing/saved_pictures.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

namespace gluray::saved {
namespace {

using frame::test::balls, frame::test::Floor;
using namespace test;

TEST(TurnedView, TurnsAroundTheScene) {
  scene::Snapshot s = balls(kSide, Floor::none);
  s.settings.ao.enabled = false;
  s.settings.lights.up = LightsUp::y;
  const SavedScene scene = sceneOf(s);
  const std::vector<uint32_t> front = pictureOf(scene), whole = pictureOf(scene, {.turn = 360});
  size_t differing = 0;
  for (size_t i = 0; i < front.size(); ++i) differing += apart(front[i], whole[i]) > 2;
  EXPECT_LT(differing, 8u);
  // By hand: the camera goes around the middle of the balls.
  for (const double degrees : {90.0, 180.0, 250.0}) {
    scene::Snapshot turned = s;
    // The box that counts is that of eye space.
    glm::dvec3 lower(1e9), upper(-1e9);
    for (const scene::Instance& i : s.instances)
      for (int c = 0; c < 8; ++c) {
        const glm::vec3 p(c & 1 ? i.mesh->upper.x : i.mesh->lower.x,
                          c & 2 ? i.mesh->upper.y : i.mesh->lower.y,
                          c & 4 ? i.mesh->upper.z : i.mesh->lower.z);
        const glm::dvec3 e(s.eyeFromWorld * glm::dvec4(p, 1));
        lower = glm::min(lower, e), upper = glm::max(upper, e);
      }
    const glm::dvec3 middle(glm::inverse(s.eyeFromWorld) * glm::dvec4((lower + upper) / 2.0, 1));
    const glm::dmat4 around = glm::translate(glm::dmat4(1), middle) *
                              glm::rotate(glm::dmat4(1), glm::radians(-degrees), glm::dvec3(0, 1, 0)) *
                              glm::translate(glm::dmat4(1), -middle);
    turned.eyeFromWorld = s.eyeFromWorld * around;
    for (scene::Instance& instance : turned.instances) instance.eyeFromObject = turned.eyeFromWorld;
    const std::vector<uint32_t> wanted = shownBy(turned, 0), got = pictureOf(scene, {.turn = degrees});
    differing = 0;
    for (size_t i = 0; i < got.size(); ++i) differing += apart(got[i], wanted[i]) > 2;
    EXPECT_LT(differing, 8u) << degrees;
    EXPECT_NE(got, front) << degrees;
  }
}

TEST(TurnedView, TurnsLightingInItsOwnSpace) {
  // The lighting's space is turned against eye space, as in programs whose matrices hold another camera.
  scene::Snapshot s =
      gluray::test::litView({gluray::test::ballMesh(40)}, gluray::test::Shader::phong, {0, 0, 1, 0});
  s.shadings[0].fragment.normals = scene::FragmentShading::Normals::vertices;
  s.settings.lights.rig = LightRig::headlightAndKey;
  for (scene::Instance& instance : s.instances) {  // normals alone say where the lights are
    instance.normalMatrix = glm::mat3(instance.eyeFromObject);
    instance.lightingFromObject = glm::mat4(1);
  }
  scene::Snapshot other = s;
  const glm::dmat4 between = glm::rotate(glm::dmat4(1), 1.0, glm::dvec3(1, 2, 3));
  other.camera.clipFromEye = s.camera.clipFromEye * between;
  other.eyeFromWorld = glm::inverse(between) * s.eyeFromWorld;
  for (scene::Instance& instance : other.instances)
    instance.eyeFromObject = glm::inverse(between) * instance.eyeFromObject;
  const std::vector<uint32_t> one = pictureOf(sceneOf(s), {.turn = 70}),
                              same = pictureOf(sceneOf(other), {.turn = 70});
  size_t differing = 0, shown = 0;
  for (size_t i = 0; i < one.size(); ++i) differing += apart(one[i], same[i]) > 2, shown += one[i] != 0;
  EXPECT_LT(differing, 8u);
  EXPECT_GT(shown, 300u);
}

TEST(TurnedView, TurnsNormalsOfScaledPositions) {
  // VTK scales coordinates in buffers, and normals not.
  scene::Snapshot s =
      gluray::test::litView({gluray::test::ballMesh(40)}, gluray::test::Shader::phong, {0, 0, 1, 0});
  s.shadings[0].fragment.normals = scene::FragmentShading::Normals::vertices;
  const glm::dmat4 scale = glm::scale(glm::dmat4(1), {1.5, 0.7, 1.1});
  for (scene::Instance& instance : s.instances) {
    instance.normalMatrix = glm::mat3(instance.eyeFromObject);
    instance.eyeFromObject = instance.eyeFromObject * scale;
    instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
  }
  const glm::mat3 before = s.instances[0].normalMatrix;
  const auto views = turned({std::make_shared<scene::Snapshot>(s)}, 70);
  const glm::mat3 turn = glm::mat3(views[0]->instances[0].eyeFromObject *
                                   glm::inverse(s.instances[0].eyeFromObject)),
                  got = views[0]->instances[0].normalMatrix, wanted = turn * before;
  for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(got[i] - wanted[i]), 1e-5f);
  EXPECT_GT(glm::length(got[0] - before[0]), 0.1f);
}

/// The scene in an eye space that is stretched along its axes, as where programs have one matrix from the
/// stretched coordinates of buffers to clip space.
scene::Snapshot stretched(scene::Snapshot s) {
  const glm::dmat4 by = glm::scale(glm::dmat4(1), {1.5, 0.7, 1.1});
  s.camera.clipFromEye = s.camera.clipFromEye * glm::inverse(by);
  s.eyeFromWorld = by * s.eyeFromWorld;
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = by * instance.eyeFromObject;
  return s;
}

TEST(TurnedView, TurnsInSpacesThatAreNotStretched) {
  scene::Snapshot s =
      gluray::test::litView({gluray::test::ballMesh(40)}, gluray::test::Shader::phong, {0, 0, 1, 0});
  s.eyeFromWorld = s.eyeFromWorld * glm::rotate(glm::dmat4(1), 0.4, glm::dvec3(1, 0.3, 0));
  for (scene::Instance& instance : s.instances) {
    instance.eyeFromObject = s.eyeFromWorld * glm::scale(glm::dmat4(1), {1, 0.6, 0.8});
    instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
  }
  const std::vector<uint32_t> wanted = pictureOf(sceneOf(s), {.turn = 70}),
                              got = pictureOf(sceneOf(stretched(s)), {.turn = 70});
  size_t differing = 0, shown = 0;
  for (size_t i = 0; i < got.size(); ++i) differing += apart(got[i], wanted[i]) > 2, shown += wanted[i] != 0;
  EXPECT_LT(differing, 8u);
  EXPECT_GT(shown, 300u);
}

TEST(TurnedView, IsRefusedWhereOnlyStretchedSpacesAreKnown) {
  scene::Snapshot s = balls(kSide, Floor::none);
  for (scene::Instance& instance : s.instances) instance.lightingFromObject = glm::mat4(1);
  EXPECT_NO_THROW(turned({std::make_shared<scene::Snapshot>(s)}, 70));
  EXPECT_THROW(turned({std::make_shared<scene::Snapshot>(stretched(s))}, 70), std::runtime_error);
}

TEST(TurnedView, TurnsWhatLayBehindTheNearPlaneIntoView) {
  scene::Snapshot s = balls(kSide, Floor::none);
  s.settings.ao.enabled = false;
  scene::Snapshot tight = s;
  tight.camera.clipFromEye = glm::perspective(glm::radians(35.0), 1.0, 4.0, 8.0);
  scene::Snapshot flat = s, flatter = s;
  flat.camera.clipFromEye = glm::ortho(-3.0, 3.0, -3.0, 3.0, 0.1, 100.0);
  flatter.camera.clipFromEye = glm::ortho(-3.0, 3.0, -3.0, 3.0, 4.0, 8.0);
  for (const auto& [roomy, narrow] : {std::pair(s, tight), std::pair(flat, flatter)}) {
    const auto expected = pictureOf(sceneOf(roomy), {.turn = 90}),
               got = pictureOf(sceneOf(narrow), {.turn = 90});
    size_t differing = 0, shown = 0;
    for (size_t i = 0; i < got.size(); ++i) differing += apart(got[i], expected[i]) > 2, shown += got[i] != 0;
    EXPECT_LT(differing, 8u);
    EXPECT_GT(shown, 300u);
  }
}

}  // namespace
}  // namespace gluray::saved
