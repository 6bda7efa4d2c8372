// What users ask of a view: what is at a pixel, which lights shine, where the camera is.
#include "accel/testing/test_scene.h"
#include "frame/questions/listed_lights.h"
#include "frame/questions/pick.h"
#include "frame/testing/test_renderer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::frame {
namespace {

constexpr int kSize = 64;

/// Two squares of the world's plane z = 0, the second one half as large and half a unit nearer to the viewer,
/// who is at (0, 0, 4) and looks along -z.
scene::Snapshot squares(bool perspective = true) {
  const auto square = [](float half, float z) {
    return gluray::test::makeMesh(
        gluray::test::quadData({-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}));
  };
  scene::Snapshot s = gluray::test::makeSnapshot({square(1, 0), square(0.5f, 0.5f)}, kSize);
  s.camera.clipFromEye = perspective ? glm::perspective(glm::radians(40.0), 1.0, 1.0, 20.0)
                                     : glm::ortho(-1.5, 1.5, -1.5, 1.5, 1.0, 20.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -4});
  for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld * glm::dmat4(i.worldFromObject);
  s.shadings[0].lighting = true;
  return s;
}

TEST(PickTest, FindsTheNearestSurfaceItsPointAndItsNormal) {
  for (const bool perspective : {true, false}) {
    const scene::Snapshot s = squares(perspective);
    const auto middle = pick(gluray::test::testRenderer(), s, {32.5, 32.5});
    ASSERT_TRUE(middle) << perspective;
    EXPECT_EQ(middle->instance, 1u);
    EXPECT_NEAR(worldPoint(s, middle->point).z, 0.5, 1e-5);
    EXPECT_NEAR(middle->normal.z, 1, 1e-6);
    EXPECT_NEAR(Viewer(s).distanceOf(middle->point), perspective ? 3.5 : 2.5, 1e-3);
    const auto aside = pick(gluray::test::testRenderer(), s, {15, 32});
    ASSERT_TRUE(aside);
    EXPECT_EQ(aside->instance, 0u);
    EXPECT_FALSE(pick(gluray::test::testRenderer(), s, {1, 1}));
    EXPECT_FALSE(pick(gluray::test::testRenderer(), s, {-5, 1000}));
  }
}

TEST(PickTest, IsTheSameWithLightLensAndSamples) {
  scene::Snapshot s = squares();
  s.settings.ao.enabled = s.settings.shadows.enabled = true;
  s.settings.integrator = LightIntegrator::path;
  s.settings.spp = 4;
  s.settings.camera.aperture = 0.5f;
  s.settings.ground.kind = GroundKind::plane;
  s.ground = scene::GroundUse::drawn;
  const auto found = pick(gluray::test::testRenderer(), s, {32.5, 32.5});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->instance, 1u);
  EXPECT_NEAR(worldPoint(s, found->point).z, 0.5, 1e-5);
}

TEST(PickTest, DoesNotMeetWhatIsHiddenFromTheCamera) {
  scene::Snapshot s = squares();
  s.instances[1].object = {9};
  s.settings.material.objects = {"9 hidden-from=camera"};
  EXPECT_EQ(pick(gluray::test::testRenderer(), s, {32.5, 32.5})->instance, 0u);
  s.settings.material.objects = {"9 hidden-from=shadow"};
  EXPECT_EQ(pick(gluray::test::testRenderer(), s, {32.5, 32.5})->instance, 1u);
}

TEST(CameraTest, IsDescribedInTheWorld) {
  const CameraDescription eye = describeCamera(squares());
  EXPECT_TRUE(eye.perspective);
  EXPECT_NEAR(eye.angle, 40, 1e-6);
  EXPECT_NEAR(eye.position.z, 4, 1e-9);
  EXPECT_NEAR(eye.direction.z, -1, 1e-9);
  EXPECT_NEAR(eye.up.y, 1, 1e-9);
  EXPECT_NEAR(eye.near, 1, 1e-9);
  EXPECT_NEAR(eye.far, 20, 1e-6);
  const CameraDescription parallel = describeCamera(squares(false));
  EXPECT_FALSE(parallel.perspective);
  EXPECT_NEAR(parallel.height, 3, 1e-9);
  EXPECT_NEAR(parallel.position.z, 3, 1e-9) << "the near plane";
  EXPECT_NEAR(parallel.far, 19, 1e-6);
}

TEST(LightsTest, AreTheProgramsUnlessARigReplacesThem) {
  scene::Snapshot s = squares();
  s.shadings[0].lights.resize(2);
  s.shadings[0].lights[0].position = {0, 3, 4, 0};
  s.shadings[0].lights[1].position = {1, 2, -3, 1};
  std::vector<ListedLight> lights = listLights(s);
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_EQ(lights[0].name, "program 1");
  EXPECT_NEAR(lights[0].source.direction.y, -0.6, 1e-6);
  EXPECT_NEAR(lights[0].angles->y, glm::degrees(std::asin(0.6)), 1e-4);
  EXPECT_EQ(lights[1].source.position, glm::vec3(1, 2, -3));
  EXPECT_FALSE(lights[1].angles);
  s.settings.lights.rig = LightRig::threePoint;
  s.settings.lights.azimuth = 20, s.settings.lights.elevation = 30;
  lights = listLights(s);
  ASSERT_EQ(lights.size(), 3u);
  EXPECT_EQ(lights[0].name, "key");
  EXPECT_NEAR(lights[0].angles->x, 20, 1e-3);
  EXPECT_NEAR(lights[0].angles->y, 30, 1e-3);
  EXPECT_EQ(lights[2].name, "back");
  s.settings.lights.rig = LightRig::sun;
  lights = listLights(s);
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_EQ(lights[0].name, "sun");
  EXPECT_TRUE(lights[1].dome);
}

TEST(LightsTest, TheHighlightIsWhereItIsAskedFor) {
  scene::Snapshot s = squares();
  s.settings.lights.rig = LightRig::threePoint;
  const glm::dvec3 point(0.5, 0.3, -4), normal = glm::normalize(glm::dvec3(0.2, 0.4, 1));
  const glm::dvec2 angles = anglesOfHighlight(s, point, normal);
  s.settings.lights.azimuth = static_cast<float>(angles.x);
  s.settings.lights.elevation = static_cast<float>(angles.y);
  const glm::dvec3 light = -glm::dvec3(listLights(s)[0].source.direction);
  const glm::dvec3 half = glm::normalize(light + glm::normalize(-point));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(half[c], normal[c], 1e-5);
}

}  // namespace
}  // namespace gluray::frame
