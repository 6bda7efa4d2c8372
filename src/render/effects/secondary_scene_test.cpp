// A snapshot with a secondary scene is lit as the same scene in one snapshot.
#include "scene/secondary_scene.h"

#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace gluray::render {
namespace {

constexpr int kSurroundedSize = 32;

/// A floor that fills the view, and beside it, out of sight, a wall and a tilted card.
scene::Snapshot whole(bool turned = false) {
  scene::Snapshot s = test::makeSnapshot({test::parallelogram({0, 0, 0}, {50, 0, 0}, {0, 50, 0}),
                                          test::parallelogram({3, 0, 2}, {0, 5, 0}, {0, 0, 2}),
                                          test::parallelogram({-3, 0, 1}, {0.5f, 0, 0.5f}, {0, 2, 0})},
                                         kSurroundedSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  if (turned) s.eyeFromWorld = glm::rotate(s.eyeFromWorld, 0.3, {1, 1, 0});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 64;
  s.settings.ao.radius = 0.1f;
  return s;
}

/// The same, all but the floor as the secondary scene.
scene::Snapshot split(scene::Snapshot s) {
  auto around = std::make_shared<scene::SecondaryScene>();
  around->instances.assign(s.instances.begin() + 1, s.instances.end());
  around->shadings = s.shadings;
  around->blended.assign(2, 0);
  s.instances.resize(1);
  s.secondaryScene = around;
  return s;
}

/// Mean brightness, 0 .. 255.
float meanGreen(const test::Traced& traced) {
  float sum = 0;
  for (int y = 0; y < kSurroundedSize; ++y)
    for (int x = 0; x < kSurroundedSize; ++x) sum += traced.color(x, y).g;
  return sum / (kSurroundedSize * kSurroundedSize);
}

TEST(SecondaryScene, DarkensAsInOneSnapshotToTheBit) {
  for (const bool turned : {false, true}) {
    const test::Traced expected = test::trace(whole(turned)), got = test::trace(split(whole(turned)));
    EXPECT_EQ(got.image.color, expected.image.color);
    EXPECT_EQ(got.image.depth, expected.image.depth);
    EXPECT_LT(meanGreen(got), 250);
  }
}

TEST(SecondaryScene, LightsPathsAsInOneSnapshotToTheBit) {
  for (const bool clipped : {false, true}) {
    scene::Snapshot s = whole();
    s.settings.integrator = LightIntegrator::path;
    s.settings.path.samples = 16;
    s.shadings[0].lighting = true;
    for (size_t i = 1; i < 3; ++i) {
      for (scene::MaterialPair& pair : s.instances[i].materials)
        pair.front.diffuse = pair.back.diffuse = {1, 0, 0, 1};
      if (clipped) s.instances[i].clipPlanes = {{0, 0, 1, 4}};
    }
    const test::Traced expected = test::trace(s), got = test::trace(split(s));
    EXPECT_EQ(got.image.color, expected.image.color);
  }
}

TEST(SecondaryScene, IsNotSeen) {
  scene::Snapshot s = split(whole());
  auto around = std::make_shared<scene::SecondaryScene>(*s.secondaryScene);
  // A card between the viewer and the floor.
  around->instances[0].mesh = test::parallelogram({0, 0, 2}, {0.5f, 0, 0}, {0, 0.5f, 0});
  s.secondaryScene = around;
  scene::Snapshot plain = s;
  plain.secondaryScene = nullptr;
  EXPECT_EQ(test::trace(s).image.depth, test::trace(plain).image.depth);
  EXPECT_NE(test::trace(s).image.color, test::trace(plain).image.color);
}

TEST(SecondaryScene, HidesAsMuchAsItsAlphaWhereItIsBlended) {
  scene::Snapshot s = split(whole());
  auto around = std::make_shared<scene::SecondaryScene>(*s.secondaryScene);
  for (scene::Instance& instance : around->instances) instance.color.a = 0.25f;
  s.secondaryScene = around;
  scene::Snapshot plain = s;
  plain.secondaryScene = nullptr;
  const float opaque = 255 - meanGreen(test::trace(s));
  auto blended = std::make_shared<scene::SecondaryScene>(*around);
  blended->blended.assign(2, 1);
  s.secondaryScene = blended;
  EXPECT_NEAR((255 - meanGreen(test::trace(s))) / opaque, 0.25f, 0.02f);
}

TEST(SecondaryScene, IsCutByItsClipPlanes) {
  scene::Snapshot s = split(whole());
  auto around = std::make_shared<scene::SecondaryScene>(*s.secondaryScene);
  for (scene::Instance& instance : around->instances) instance.clipPlanes = {{0, 0, 0, -1}};
  s.secondaryScene = around;
  EXPECT_EQ(meanGreen(test::trace(s)), 255);
}

TEST(SecondaryScene, WithoutAPlaceIsLeftOut) {
  scene::Snapshot s = split(whole());
  auto around = std::make_shared<scene::SecondaryScene>(*s.secondaryScene);
  for (scene::Instance& instance : around->instances)
    instance.eyeFromObject = glm::dmat4(0), instance.worldFromObject = glm::mat4(0);
  s.secondaryScene = around;
  EXPECT_EQ(meanGreen(test::trace(s)), 255);
}

}  // namespace
}  // namespace gluray::render
