// Moving frames of surfaces that only take light: opacities without shading them are those with it.
#include "render/testing/test_animation.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace gluray::render {
namespace {

using test::Animation;
using test::boards;
using test::turn;

/// The boards as draws of the real OpenGL whose light GLuRay finds. A second material, which no triangle
/// has, makes frames shade them.
scene::Snapshot catchingBoards(bool shaded) {
  scene::Snapshot s = boards();
  s.catches = true;
  scene::Shading shading;
  shading.fragment.model = scene::FragmentShading::Model::phong;
  shading.fragment.normals = scene::FragmentShading::Normals::triangles;
  s.shadings = {shading};
  scene::Material matte;
  matte.ambient = matte.diffuse = glm::vec4(glm::vec3(1.0f / 16), 1);
  for (scene::Instance& instance : s.instances) {
    instance.shading = 0;
    instance.materials = {{matte, matte}};
    if (shaded) instance.materials.push_back({matte, matte});
  }
  return s;
}

TEST(CaughtFrames, HaveTheOpacitiesOfShadedOnes) {
  for (const bool quarter : {false, true})
    for (const float strength : {1.0f, 0.6f}) {
      Animation plain, shaded;
      plain.rays.quarter = shaded.rays.quarter = quarter;
      scene::Snapshot a = catchingBoards(false), b = catchingBoards(true);
      a.settings.ao.strength = b.settings.ao.strength = strength;
      for (int frame = 0; frame < 4; ++frame) {
        turn(a, frame), turn(b, frame);
        const Image got = plain.frame(a).image, expected = shaded.frame(b).image;
        ASSERT_EQ(got.depth, expected.depth);
        int darker = 0;
        for (size_t i = 0; i < got.color.size(); ++i) {
          ASSERT_EQ(got.color[i] & 0xFFFFFF, expected.color[i] & 0xFFFFFF);
          // The ratio of two luminances is the visibility up to rounding.
          ASSERT_LE(
              std::abs(static_cast<int>(got.color[i] >> 24) - static_cast<int>(expected.color[i] >> 24)), 1);
          darker += (got.color[i] >> 24) > 40;
        }
        EXPECT_GT(darker, 100);
      }
    }
}

TEST(CaughtFrames, WithLightsAreShaded) {
  Animation one;
  scene::Snapshot s = catchingBoards(false);
  scene::FragmentLight light;
  light.kind = scene::FragmentLight::headlight;
  light.color = glm::vec3(1);
  s.shadings[0].fragment.lights = {light};
  s.settings.ao.on = AmbientOcclusionOn::ambient;
  turn(s, 0);
  const Image lit = one.frame(s).image;
  Animation other;
  scene::Snapshot dark = catchingBoards(false);
  turn(dark, 0);
  const Image unlit = other.frame(dark).image;
  uint64_t takenLit = 0, takenUnlit = 0;
  for (const uint32_t color : lit.color) takenLit += color >> 24;
  for (const uint32_t color : unlit.color) takenUnlit += color >> 24;
  EXPECT_LT(5 * takenLit, 4 * takenUnlit) << "occlusion darkens only the ambient part of their light";
}

}  // namespace
}  // namespace gluray::render
