// Rays that end where the framebuffer has surfaces find the same ones.
#include "render/frame_data/known_depths.h"

#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace gluray::render {
namespace {

constexpr int kDepthsSize = 64;

/// A tilted floor with a wall on it, and `lid`: a card before both.
scene::Snapshot catchers(bool lid, bool parallel) {
  std::vector<scene::MeshPtr> meshes{test::parallelogram({0, -0.5f, 0}, {2, 0, 0}, {0, 0.5f, -2}),
                                     test::parallelogram({0.5f, 0, 0}, {0, 0.7f, 0}, {0, 0, 1})};
  if (lid) meshes.push_back(test::parallelogram({0, 0, 1.5f}, {0.4f, 0, 0}, {0, 0.4f, 0}));
  scene::Snapshot s = test::makeSnapshot(meshes, kDepthsSize);
  s.camera.clipFromEye = parallel ? glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.5, 20.0)
                                  : glm::perspective(glm::radians(45.0), 1.0, 0.5, 20.0);
  s.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), 0.4, {1, 0.3, 0});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.catches = true;
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 16;
  return s;
}

/// The snapshot with the depths of an image in the framebuffer, which was cleared to 1.
scene::Snapshot over(scene::Snapshot s, const Image& shown) {
  auto capture = std::make_shared<scene::FramebufferCapture>();
  capture->viewport = s.camera.viewport;
  capture->region = s.region;
  for (const float depth : shown.depth) capture->depths.push_back(depth == Image::kMiss ? 1 : depth);
  auto around = std::make_shared<scene::SecondaryScene>();
  around->framebuffer = capture;
  s.secondaryScene = around;
  return s;
}

TEST(KnownDepths, LeaveTheImageToTheBit) {
  for (const bool parallel : {false, true})
    for (const bool lid : {false, true}) {
      const scene::Snapshot s = catchers(lid, parallel);
      const test::Traced expected = test::trace(s), got = test::trace(over(s, expected.image));
      EXPECT_EQ(got.image.color, expected.image.color);
      EXPECT_EQ(got.image.depth, expected.image.depth);
    }
}

/// Where a program's shader has left out the card, rays find what shows behind it.
TEST(KnownDepths, FindWhatShowsThroughHoles) {
  for (const bool parallel : {false, true}) {
    const test::Traced behind = test::trace(catchers(false, parallel)),
                       before = test::trace(catchers(true, parallel)),
                       got = test::trace(over(catchers(true, parallel), behind.image));
    EXPECT_NE(before.image.depth, behind.image.depth);
    EXPECT_EQ(got.image.depth, behind.image.depth);
  }
}

TEST(KnownDepths, FindNothingWhereTheFramebufferIsClear) {
  Image clear = test::trace(catchers(true, false)).image;
  std::fill(clear.depth.begin(), clear.depth.end(), Image::kMiss);
  const test::Traced got = test::trace(over(catchers(true, false), clear));
  EXPECT_EQ(got.image.depth, clear.depth);
}

}  // namespace
}  // namespace gluray::render
