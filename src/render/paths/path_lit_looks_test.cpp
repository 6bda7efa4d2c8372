// Lights of files in paths: beside shadows of the local look, where they are seen, and of absurd values.
#include "base/sanitized.h"
#include "render/testing/path_lit_scenes.h"
#include "scene/secondary_scene.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace gluray::render {
namespace {

using test::LightFile;
using test::litBy;
using test::radiances;

/// The same scene by the localShadows look with shadows.
scene::Snapshot localShadows(scene::Snapshot s) {
  s.settings.integrator = LightIntegrator::local;
  s.settings.shadows.enabled = true, s.settings.shadows.samples = 1024;
  return s;
}

TEST(PathLights, AgreeWithShadowsOfTheLocalLook) {
  GLURAY_RELEASE_ONLY();
  // A ball between the wall and lights whose middles are partly below the horizon of what they shine on. Both
  // images take 1024 samples a pixel; their noise is measured by halves of the paths.
  const LightFile file(
      "[[light]]\nkind = 'rectangle'\nposition = [-2, 1, 2]\ntarget = [0, 0, 0]\nwidth = 2\nheight = 3\n"
      "[[light]]\nkind = 'disc'\nposition = [2, -1, 1]\ndirection = [-1, 0.5, 0]\nradius = 0.8\nstrength = "
      "0.5\n"
      "[[light]]\nkind = 'sphere'\nposition = [0, 2.5, 0.4]\nradius = 0.6\nstrength = 0.7\n");
  scene::Snapshot s = litBy(file, {test::backWall(), test::ballMesh(60, 0.8f, {0, 0, 1})}, 40);
  s.settings.path.samples = 512;
  for (scene::Instance& i : s.instances) {
    test::setAlbedo(i, {0.5f, 0.6f, 0.7f});
    i.materials[0].front.ambient = i.materials[0].back.ambient = {0, 0, 0, 1};
  }
  s.shadings[0].globalAmbient = {0, 0, 0, 1};
  const auto look = radiances(localShadows(s)), first = radiances(s);
  s.lightSampling.pass = 1;
  const auto second = radiances(s);
  double apart = 0, noise = 0, biased = 0, brightness = 0;
  int count = 0;
  for (int y = 0; y < test::kPathSize; ++y)
    for (int x = 0; x < test::kPathSize; ++x) {
      const double a = first.at(x, y).g, b = second.at(x, y).g, c = look.at(x, y).g;
      apart += std::pow(0.5 * (a + b) - c, 2), noise += std::pow(0.5 * (a - b), 2);
      biased += 0.5 * (a + b) - c, brightness += c, ++count;
    }
  EXPECT_NEAR(biased / count, 0, 0.002 * brightness / count);
  EXPECT_LT(std::sqrt(noise / count), 0.005);
  // The look's noise is of the paths' order.
  EXPECT_LT(apart, 4 * noise);
}

/// A file of one sphere that holds the whole scene, of radiance 1.
std::string skyOfSphere(bool visible) {
  return std::string("[[light]]\nkind = 'sphere'\nposition = [0.5, 0, 0]\nradius = 20\n") +
         (visible ? "visible = true\n" : "");
}

TEST(PathLights, WhiteBodiesVanishInAVisibleSphere) {
  const LightFile file(skyOfSphere(true));
  for (const auto kind : {SurfaceMaterial::program, SurfaceMaterial::mirror, SurfaceMaterial::glass,
                          SurfaceMaterial::thinGlass, SurfaceMaterial::plastic})
    for (const float roughness : {0.0f, 0.5f}) {
      if (kind == SurfaceMaterial::glass && roughness > 0) continue;  // loses what meets two facets
      scene::Snapshot s = litBy(file, {test::ballMesh(60)}, 40);
      s.settings.material.kind = kind, s.settings.material.roughness = roughness;
      s.settings.path.depth = 64;
      const auto image = radiances(s);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.mean()[c], 1, 0.01f) << int(kind) << ' ' << roughness;
    }
}

TEST(PathLights, MirrorsShowVisibleLightsAlone) {
  for (const bool visible : {false, true}) {
    const LightFile file(skyOfSphere(visible));
    scene::Snapshot s = litBy(file, {test::ballMesh(60)}, 10);
    s.settings.material.kind = SurfaceMaterial::mirror;
    EXPECT_NEAR(radiances(s).mean().g, visible, 1e-4f);
  }
}

/// A snapshot of a rough metal wall under one sphere.
scene::Snapshot roughMetal(const LightFile& file, float roughness) {
  scene::Snapshot s = litBy(file, {test::backWall()}, 30);
  s.settings.material.kind = SurfaceMaterial::principled;
  s.settings.material.metallic = 1, s.settings.material.roughness = roughness;
  s.settings.path.samples = 256;
  return s;
}

TEST(PathLights, ReflectionsOfLightsAreThoseOfBallsThatEmit) {
  GLURAY_RELEASE_ONLY();
  // The ball stands behind the viewer, so that only paths see it. The mesh is met by chance alone.
  const LightFile file("[[light]]\nkind = 'sphere'\nposition = [0, 1, 8]\nradius = 2\n"), none("");
  for (const float roughness : {0.1f, 0.3f, 0.7f}) {
    const auto lit = radiances(roughMetal(file, roughness));
    scene::Snapshot s = roughMetal(none, roughness);
    const scene::Snapshot with = litBy(none, {test::backWall(), test::ballMesh(200, 2, {0, 1, 8})}, 30);
    s.instances = with.instances;
    s.shadings.push_back(s.shadings[0]), s.shadings[1].lighting = false;
    s.instances[1].shading = 1, s.instances[1].color = glm::vec4(1);
    s.settings.path.samples = 1024;
    const auto met = radiances(s);
    EXPECT_NEAR(lit.mean().g, met.mean().g, 0.01f * met.mean().g + 1e-4f) << roughness;
    for (int x = 0; x < test::kPathSize; x += 8)
      EXPECT_NEAR(lit.mean(x, x + 8).g, met.mean(x, x + 8).g, 0.02f * met.mean().g) << roughness << ' ' << x;
  }
}

TEST(PathLights, ShineThroughGlassWhetherSeenOrNot) {
  GLURAY_RELEASE_ONLY();
  // Between light and wall stands a pane, which paths cross straight: a visible light is met behind it, an
  // invisible one shines through it.
  float brightness[2];
  for (const bool visible : {false, true}) {
    const LightFile file("[[light]]\nkind = 'sphere'\nposition = [0, 0, 4]\nradius = 2\nvisible = " +
                         std::string(visible ? "true\n" : "false\n"));
    const LightFile rules("[[rule]]\nobjects = [1]\nmaterial = 'thin-glass'\n");
    scene::Snapshot s = litBy(file, {test::backWall(), test::parallelogram({0, 0, 1}, {9, 0, 0}, {0, 9, 0})});
    s.settings.material.file = rules.name;
    s.instances[1].order = 1;
    // The viewer is behind the pane.
    s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -0.9});
    for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld;
    s.camera.clipFromEye = glm::perspective(glm::radians(0.5), 1.0, 0.01, 1000.0);
    s.settings.path.depth = 2, s.settings.path.samples = 256;
    brightness[visible] = radiances(s).mean().g;
  }
  // 0.25 in the open; the pane reflects 0.08, more at an angle.
  EXPECT_NEAR(brightness[0], 0.25f * 0.96f, 0.005f);
  EXPECT_NEAR(brightness[1], 0.25f * 0.915f, 0.01f);
}

TEST(PathLights, AreTheSameForAnyNumberOfThreadsAndNearlyForAnyInstructionSet) {
  GLURAY_RELEASE_ONLY();
  const LightFile file(
      "[[light]]\nkind = 'rectangle'\nposition = [0, 3, 2]\ntarget = [0, 0, 0]\n"
      "[[light]]\nkind = 'sphere'\nposition = [2, 0, 2]\nradius = 0.3\nvisible = true\n"
      "[[light]]\nkind = 'spot'\nposition = [0, 0, 4]\ntarget = [0, 0, 0]\nradius = 0.1\n");
  scene::Snapshot s = litBy(file, {test::backWall(), test::ballMesh(12, 1, {0, 0, 1})}, 40);
  s.settings.path.depth = 3;
  const auto one = radiances(s);
  s.settings.threads = 4;
  EXPECT_EQ(one.traced.image.wideColor, radiances(s).traced.image.wideColor);
  test::withEachTarget([&](int64_t) { EXPECT_NEAR(radiances(s).mean().g, one.mean().g, 0.003f); });
}

TEST(PathLights, OfAbsurdValuesAreNumbers) {
  const char* const lights[] = {
      "kind = 'sphere'\nposition = [0, 0, 0]\nradius = 1e-15\nstrength = 1e6\ncolor = [1000, 1000, 1000]\n",
      "kind = 'sphere'\nposition = [0, 0, 0.5]\nradius = 1e30\nvisible = true\n",
      "kind = 'sphere'\nposition = [0, 0, 1]\nradius = 1\nvisible = true\n",
      "kind = 'point'\nposition = [0, 0, 0]\nattenuation = [0, 0, 1e30]\n",
      "kind = 'point'\nposition = [0, 0, 0]\nattenuation = [0, 0, 1]\nstrength = 1e6\n",
      "kind = 'point'\nposition = [1e30, 0, 0]\nradius = 1e30\n",
      "kind = 'spot'\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\ncone = 0\nexponent = 128\nradius = 1\n",
      "kind = 'rectangle'\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\nwidth = 1e-30\nheight = 1e30\n",
      "kind = 'rectangle'\nposition = [0, 0, 0]\ndirection = [0, 0, -1]\nwidth = 10\nvisible = true\n",
      "kind = 'rectangle'\nposition = [0, 0, 1e-6]\ndirection = [0, 0, -1]\nstrength = 1e6\n",
      "kind = 'disc'\nposition = [0, 0, 3]\ndirection = [1, 0, 0]\nradius = 1e30\n",
      "kind = 'disc'\nposition = [-1e30, 0, 3]\ndirection = [1, 0, 0]\nradius = 1e-15\nvisible = true\n",
      "kind = 'distant'\ndirection = [1e-30, 0, 0]\nangle = 1e-30\nvisible = true\n"};
  std::vector<std::string> files;
  std::string all;
  for (const char* light : lights) {
    all += std::string("[[light]]\n") + light;
    files.push_back(std::string("[[light]]\n") + light);
    if (!kSanitized) files.push_back(all);
  }
  files.push_back(all);
  for (const std::string& text : files)
    for (const bool paths : {false, true}) {
      const LightFile file(text);
      scene::Snapshot s = litBy(file, {test::backWall(), test::ballMesh(12)}, 40);
      s.settings.path.samples = kSanitized ? 1 : 4, s.settings.path.depth = 4;
      s.settings.shadows.size = 90;
      const auto image = radiances(paths ? s : localShadows(s));
      for (int y = 0; y < test::kPathSize; ++y)
        for (int x = 0; x < test::kPathSize; ++x)
          for (int c = 0; c < 3; ++c)
            ASSERT_TRUE(std::isfinite(image.at(x, y)[c]) && image.at(x, y)[c] >= 0) << text;
    }
}

TEST(PathLights, OfScenesOfAnySize) {
  const auto imageOf = [](double size) {
    char text[400];
    std::snprintf(text, sizeof text,
                  "[[light]]\nkind = 'rectangle'\nposition = [0, %g, %g]\ntarget = [0, 0, 0]\nwidth = %g\n"
                  "height = %g\n[[light]]\nkind = 'sphere'\nposition = [%g, 0, %g]\nradius = %g\n",
                  3 * size, 2 * size, 2 * size, 2 * size, 2 * size, 2 * size, 0.5 * size);
    const LightFile file(text);
    const auto f = static_cast<float>(size);
    scene::Snapshot s = litBy(file, {test::parallelogram({0, 0, 0}, {9 * f, 0, 0}, {0, 9 * f, 0}),
                                     test::ballMesh(12, f, {0, 0, f})});
    s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1 * size, 1000.0 * size);
    s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5 * size});
    for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld;
    return radiances(s).mean().g;
  };
  const float plain = imageOf(1);
  for (const double size : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9})
    EXPECT_NEAR(imageOf(size), plain, 0.002f) << size;
}

TEST(PathLights, ShineOnTheSecondarySceneInPlaceOfItsOwn) {
  // A mirror shows a wall behind the viewer, which another batch drew under a light of its own.
  scene::Snapshot s = test::pathView({test::parallelogram({0, 0, 0}, {3, 0, 0}, {0, 3, 0})});
  const scene::Snapshot behind = test::pathView({test::parallelogram({0, 0, 20}, {500, 0, 0}, {0, 500, 0})});
  auto around = std::make_shared<scene::SecondaryScene>();
  around->instances = behind.instances, around->blended = {0};
  around->shadings = behind.shadings;
  around->shadings[0].lights.resize(1);
  around->shadings[0].lights[0].position = {1, 0, -1, 0},
  around->shadings[0].lights[0].diffuse = glm::vec4(9);
  around->instances[0].order = 1;
  s.secondaryScene = around;
  const LightFile rules("[[rule]]\nobjects = [0]\nmaterial = 'mirror'\n");
  s.settings.material.file = rules.name;
  s.settings.environment.strength = 0, s.settings.path.depth = 2, s.settings.path.samples = 16;
  EXPECT_NEAR(radiances(s).mean().g, 9 * std::sqrt(0.5f), 0.01f);
  s.settings.lights.rig = LightRig::sun;
  s.settings.lights.azimuth = 135, s.settings.lights.elevation = 0, s.settings.lights.ratio = 1e4f;
  s.settings.shadows.size = 0;
  EXPECT_NEAR(radiances(s).mean().g, std::sqrt(0.5f), 0.002f);
}

}  // namespace
}  // namespace gluray::render
