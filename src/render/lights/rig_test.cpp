#include "render/lights/rig.h"

#include "render/testing/lit_wall.h"
#include "render/testing/test_ball.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

using test::Shader;
using test::Traced;

Settings with(LightRig rig) {
  Settings s;
  s.lights.rig = rig;
  return s;
}

constexpr LightRig kRigs[] = {LightRig::headlightAndKey, LightRig::threePoint, LightRig::sun, LightRig::sky};

TEST(Rig, IsNoneForTheProgramsLights) { EXPECT_FALSE(makeRig(with(LightRig::program), glm::dmat4(1))); }

TEST(Rig, KeyComesFromTheUpperRightFrontWhicheverAxisIsUp) {
  for (const LightsUp up : {LightsUp::x, LightsUp::y, LightsUp::z}) {
    Settings s = with(LightRig::headlightAndKey);
    s.lights.up = up, s.lights.azimuth = 45, s.lights.attached = LightsAttached::scene;
    const glm::vec3 towards = -makeRig(s, glm::dmat4(1))->lights[0].direction;
    EXPECT_GT(glm::dot(towards, glm::normalize(glm::vec3(1))), 0.9999f);
  }
}

TEST(Rig, KeyStaysWithTheCameraAndTheSunInTheScene) {
  const glm::dmat4 turned =
      glm::rotate(glm::dmat4(1), glm::radians(70.0), glm::normalize(glm::dvec3(1, 2, 3)));
  const auto keyOf = [](const Settings& s, const glm::dmat4& m) {
    return glm::dvec3(makeRig(s, m)->lights[0].direction);
  };
  for (const LightRig rig : {LightRig::headlightAndKey, LightRig::programAndKey, LightRig::threePoint}) {
    Settings s = with(rig);
    EXPECT_EQ(keyOf(s, turned), keyOf(s, glm::dmat4(1)));
    s.lights.attached = LightsAttached::scene;
    EXPECT_LT(glm::length(keyOf(s, turned) - glm::dmat3(turned) * keyOf(s, glm::dmat4(1))), 1e-6);
  }
  Settings s = with(LightRig::sun);
  EXPECT_LT(glm::length(keyOf(s, turned) - glm::dmat3(turned) * keyOf(s, glm::dmat4(1))), 1e-6);
  s.lights.attached = LightsAttached::camera;
  EXPECT_EQ(keyOf(s, turned), keyOf(s, glm::dmat4(1)));
}

TEST(Rig, DirectionsAreRightAngledInScaledAndMirroredWorlds) {
  for (const glm::dvec3& scale : {glm::dvec3(1, 1, 10), glm::dvec3(1e-9, 1, -3), glm::dvec3(1e12)}) {
    const glm::dmat4 m = glm::rotate(glm::dmat4(1), 1.0, glm::normalize(glm::dvec3(3, 1, 2))) *
                         glm::scale(glm::dmat4(1), scale);
    for (int up = 0; up < 3; ++up) {
      const Directions d = sceneDirections(m, up);
      EXPECT_NEAR(glm::dot(d.up, d.front), 0, 1e-9);
      EXPECT_NEAR(glm::dot(d.up, d.right), 0, 1e-9);
      EXPECT_NEAR(glm::dot(d.front, d.right), 0, 1e-9);
      EXPECT_GT(glm::dot(d.up, glm::normalize(glm::dvec3(m[up]))), 0.999999);
      EXPECT_GT(glm::dot(d.right, glm::dvec3(m[(up + 2) % 3])), 0);
    }
  }
}

/// A white ball of many facets before the camera, lit by a rig in place of the program's dim light.
Traced ball(Shader shader, LightRig rig) {
  scene::Snapshot s = test::litView({test::ballMesh(60)}, shader, {0, -1, 0, 0});
  s.shadings[0].fragment.normals = scene::FragmentShading::Normals::vertices;
  s.settings.shadows.enabled = false;
  s.settings.lights.rig = rig;
  return test::trace(s);
}

TEST(Rig, IsAboutAsBrightAsAHeadlight) {
  for (const Shader shader : {Shader::fixedFunction, Shader::phong})
    for (const LightRig rig : kRigs) {
      const Traced traced = ball(shader, rig);
      float most = 0, sum = 0;
      int count = 0, full = 0;
      for (int y = 0; y < test::kLitSize; ++y)
        for (int x = 0; x < test::kLitSize; ++x)
          if (traced.hit(x, y)) {
            const float g = traced.color(x, y).g;
            most = std::max(most, g), sum += g, ++count, full += g >= 255 ? 1 : 0;
          }
      EXPECT_GT(most, 225) << static_cast<int>(rig);
      EXPECT_LT(full, count / 20) << "blown out by " << static_cast<int>(rig);
      EXPECT_NEAR(sum / static_cast<float>(count), 170, 45) << static_cast<int>(rig);
    }
}

TEST(Rig, KeepsTheProgramsLightsBesideItsKey) {
  for (const Shader shader : {Shader::fixedFunction, Shader::phong}) {
    scene::Snapshot s = test::litView({test::ballMesh(60)}, shader, {0, 0, 1, 0});
    s.settings.shadows.enabled = false;
    for (scene::Light& light : s.shadings[0].lights) light.diffuse = {0, 0.5f, 0, 1}, light.specular = {};
    for (scene::FragmentLight& light : s.shadings[0].fragment.lights) light.color = {0, 0.5f, 0};
    s.settings.lights.rig = LightRig::programAndKey;
    const Traced traced = test::trace(s);
    int greens = 0;
    for (int y = 0; y < test::kLitSize; ++y)
      for (int x = 0; x < test::kLitSize; ++x) {
        if (!traced.hit(x, y)) continue;
        const glm::vec4 color = traced.color(x, y);
        EXPECT_LE(color.r, 0) << "the key has the colour of the program's light";
        greens += color.g > 60 ? 1 : 0;
      }
    EXPECT_GT(greens, 300);
  }
}

TEST(Rig, LightsFixedFunctionAndProgramsAlike) {
  for (const LightRig rig : kRigs) {
    const Traced fixed = ball(Shader::fixedFunction, rig), program = ball(Shader::phong, rig);
    int apart = 0;
    for (int y = 0; y < test::kLitSize; ++y)
      for (int x = 0; x < test::kLitSize; ++x)
        if (fixed.hit(x, y)) apart += test::difference(fixed.color(x, y), program.color(x, y)) > 16 ? 1 : 0;
    // The program's light at the viewer is parallel.
    EXPECT_LT(apart, 60) << static_cast<int>(rig);
  }
}

TEST(Rig, IsTheSameWhereAProgramGivesOneMatrixForAll) {
  // As VTK with a light at the viewer: the whole transform is in the projection, and only the matrix of
  // normals says how the view is turned.
  const glm::dmat4 view = glm::translate(glm::dmat4(1), {0, 0, -5}) *
                          glm::rotate(glm::dmat4(1), 1.0, glm::normalize(glm::dvec3(1, 2, -1)));
  for (const LightRig rig : kRigs)
    for (const bool parallel : {false, true}) {
      scene::Snapshot s =
          test::litView({test::wall(2), test::parallelogram({0.3f, 0.2f, 0.5f}, {0.4f, 0, 0}, {0, 0.4f, 0})},
                        Shader::phong, {0, 0, 1, 0});
      s.settings.lights.rig = rig;
      s.settings.shadows.samples = 64;
      if (parallel) s.camera.clipFromEye = glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.1, 1000.0);
      s.eyeFromWorld = view;
      s.shadings[0].fragment.normals = scene::FragmentShading::Normals::vertices;
      for (scene::Instance& i : s.instances) {
        i.eyeFromObject = view, i.lightingFromObject = glm::mat4(view);
        i.normalMatrix = glm::mat3(glm::transpose(glm::inverse(glm::dmat3(view))));
        // A parallel view has no viewer at the origin, where the ordinary matrix has one.
        i.materials[0].front.specular = glm::vec4(parallel ? 0 : 0.3f);
        i.materials[0].front.shininess = 10;
        auto mesh = std::make_shared<scene::Mesh>(*i.mesh);
        mesh->lower = {-2, -2, 0}, mesh->upper = {2, 2, 0.5f};
        i.mesh = mesh;
      }
      const Traced ordinary = test::trace(s);
      s.camera.clipFromEye = s.camera.clipFromEye * view;
      s.eyeFromWorld = glm::dmat4(1);
      for (scene::Instance& i : s.instances)
        i.eyeFromObject = glm::dmat4(1), i.lightingFromObject = glm::mat4(1);
      const Traced whole = test::trace(s);
      double sum = 0;
      int hits = 0;
      for (int y = 0; y < test::kLitSize; ++y)
        for (int x = 0; x < test::kLitSize; ++x)
          if (ordinary.hit(x, y)) {
            sum += test::difference(ordinary.color(x, y), whole.color(x, y)), ++hits;
            EXPECT_LE(test::difference(ordinary.color(x, y), whole.color(x, y)), 60) << x << " " << y;
          }
      EXPECT_GT(hits, 300);
      // Light from all sides has noise.
      EXPECT_LT(sum / hits, rig == LightRig::sky ? 2.5 : 1)
          << static_cast<int>(rig) << (parallel ? " parallel" : "");
    }
}

TEST(Rig, LeavesUnlitSurfacesAsTheyAre) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())}, 8);
  s.instances[0].color = {0.2f, 0.4f, 0.6f, 1};
  const Traced plain = test::trace(s);
  for (const LightRig rig : kRigs) {
    s.settings.lights.rig = rig;
    s.settings.shadows.enabled = true;
    EXPECT_EQ(test::trace(s).image.color, plain.image.color);
  }
}

TEST(Rig, SkyIsOccludedByWhatStandsAgainstIt) {
  // The wall, and an endless one at right angles to it at x = 3, beyond the view.
  for (const Shader shader : {Shader::fixedFunction, Shader::phong}) {
    scene::Snapshot s = test::litView(
        {test::wall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})}, shader, {0, 0, 1, 0});
    s.settings.lights.rig = LightRig::sky;
    s.settings.lights.attached = LightsAttached::camera;
    s.settings.shadows.samples = 256;
    const auto at = [&] { return test::trace(s).color(20, 20).g / 255; };
    // Half of the hemisphere is sky, 1, half is ground, 0.4, and so is what the second wall hides.
    EXPECT_NEAR(at(), 0.35f, 0.02f);
    s.settings.shadows.enabled = false;
    EXPECT_NEAR(at(), 0.7f, 0.005f);
    s.settings.ao.enabled = true, s.settings.ao.radius = 100, s.settings.ao.samples = 256;
    EXPECT_NEAR(at(), 0.35f, 0.02f);
    s.settings.ao.on = AmbientOcclusionOn::ambient;
    EXPECT_NEAR(at(), 0.35f, 0.02f);
  }
}

TEST(Rig, CastsShadowsOfItsKeyAlone) {
  for (const Shader shader : {Shader::fixedFunction, Shader::phong}) {
    scene::Snapshot s = test::litView({test::wall(), test::screen()}, shader, {0, 0, 1, 0});
    s.settings.lights.rig = LightRig::headlightAndKey;
    s.settings.lights.azimuth = 45, s.settings.lights.elevation = 0;
    const Traced traced = test::trace(s);
    const float lit = traced.color(4, 32).g, dark = traced.color(60, 32).g;
    EXPECT_NEAR(lit, 255 * 0.841f, 6) << "both lights, the key at 45 degrees";
    EXPECT_GT(dark, 70);
    EXPECT_LT(dark, 100) << "the light at the viewer";
  }
}

}  // namespace
}  // namespace gluray::render
