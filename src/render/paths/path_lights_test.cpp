// Lights of rigs and files in paths, against their light in closed form.
#include "render/testing/path_lit_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gluray::render {
namespace {

using test::LightFile;
using test::litBy;
using test::radiances;

/// What a white wall shows at the origin, and the standard error of its 1024 pixels of 64 paths.
void expectOnWall(const LightFile& file, double wanted) {
  const scene::Snapshot s = litBy(file);
  const auto image = radiances(s);
  double square = 0;
  for (int y = 0; y < test::kPathSize; ++y)
    for (int x = 0; x < test::kPathSize; ++x) square += std::pow(image.at(x, y).g - wanted, 2);
  const double pixels = test::kPathSize * test::kPathSize;
  const double error = std::sqrt(square) / pixels;
  EXPECT_LT(error, 0.002 * wanted) << "so little noise that the mean tells something";
  EXPECT_NEAR(image.mean().g, wanted, 5 * error + 1e-4 * wanted);
}

constexpr char kTowards[] = "target = [0, 0, 0]\n";

TEST(PathLights, ASphereShinesAsTheSquareOfItsSine) {
  expectOnWall(LightFile("[[light]]\nkind = 'sphere'\nposition = [0, 0, 3]\nradius = 1.5\n"), 0.25);
  expectOnWall(LightFile("[[light]]\nkind = 'sphere'\nposition = [4, 0, 3]\nradius = 0.5\n"),
               0.25 / 25 * 3 / 5);
}

TEST(PathLights, ASphereThatHoldsThePointShinesOnItFromAllSides) {
  expectOnWall(
      LightFile("[[light]]\nkind = 'sphere'\nposition = [0.2, 0, 0.3]\nradius = 2\nstrength = 0.7\n"), 0.7);
}

TEST(PathLights, ADiscOnTheAxisShinesAsItsFormFactor) {
  expectOnWall(
      LightFile(std::string("[[light]]\nkind = 'disc'\nposition = [0, 0, 3]\nradius = 2\n") + kTowards),
      4.0 / (4 + 9));
}

TEST(PathLights, ARectangleShinesAsItsFormFactor) {
  // The corner of a parallel rectangle a x b at height c above the point, four times.
  const double a = 1.5 / 2, b = 1.0 / 2;  // over c = 2
  const double x = std::sqrt(1 + a * a), y = std::sqrt(1 + b * b);
  const double corner = (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2 * M_PI);
  expectOnWall(LightFile(std::string("[[light]]\nkind = 'rectangle'\nposition = [0, 0, 2]\nwidth = 3\n"
                                     "height = 2\n") +
                         kTowards),
               4 * corner);
}

TEST(PathLights, AreasShineToTheFrontAlone) {
  for (const char* kind : {"disc", "rectangle"}) {
    const LightFile file("[[light]]\nkind = '" + std::string(kind) +
                         "'\nposition = [0, 0, 2]\ndirection = [0, 0, 1]\n");
    EXPECT_EQ(radiances(litBy(file)).mean(), glm::vec3(0));
  }
}

TEST(PathLights, LightsOfStrengthOneMakeAWhiteSurfaceThatFacesThemWhite) {
  for (const char* size : {"0", "0.53", "30", "90"})
    expectOnWall(
        LightFile("[[light]]\nkind = 'distant'\ndirection = [0, 0, -1]\nangle = " + std::string(size) + "\n"),
        1);
  for (const char* radius : {"0", "0.1", "2", "2.9"})
    expectOnWall(
        LightFile("[[light]]\nkind = 'point'\nposition = [0, 0, 3]\nradius = " + std::string(radius) + "\n"),
        1);
  expectOnWall(LightFile("[[light]]\nkind = 'point'\nposition = [0, 0, 2]\nattenuation = [1, 1, 0.25]\n"),
               0.25);
}

TEST(PathLights, LightsWithoutASizeHaveThatOfShadows) {
  const LightFile file("[[light]]\nkind = 'distant'\ndirection = [-1, 0, -1]\n");
  // A screen that hides half of the light.
  scene::Snapshot s =
      litBy(file, {test::backWall(), test::parallelogram({52, 0, 2}, {50, 0, 0}, {0, 50, 0})}, 0.01);
  s.settings.shadows.size = 10;
  EXPECT_NEAR(radiances(s).mean().g, 0.5f * std::sqrt(0.5f), 0.02f);
}

TEST(PathLights, SpotsLightTheirCone) {
  const LightFile file("[[light]]\nkind = 'spot'\nposition = [0, 0, 3]\ndirection = [0, 0, -1]\ncone = 20\n");
  const auto image = radiances(litBy(file, {test::backWall()}, 40));
  const float half = 5 * std::tan(glm::radians(20.0f)), rim = 3 * std::tan(glm::radians(20.0f));
  for (int x = 0; x < test::kPathSize; ++x) {
    const auto at = [&](int i) {
      return ((static_cast<float>(i) + 0.5f) / (test::kPathSize / 2) - 1) * half;
    };
    const float from = std::hypot(at(x), at(16));
    EXPECT_EQ(image.at(x, 16).g > 0, from < rim) << x;
    if (from < rim) { EXPECT_NEAR(image.at(x, 16).g, 3 / std::hypot(3.0f, from), 1e-4f); }
  }
}

TEST(PathLights, ManyLightsAddUp) {
  std::string text;
  double sum = 0;
  for (int i = 0; i < 20; ++i) {
    const double z = 2 + i, strength = i % 3 + 0.5;
    text += "[[light]]\nkind = 'sphere'\nposition = [0, 0, " + std::to_string(z) +
            "]\nradius = 0.5\nstrength = " + std::to_string(strength) + "\n";
    sum += strength * 0.25 / (z * z);
  }
  expectOnWall(LightFile(text), sum);
}

TEST(PathLights, RigsTakeThePlaceOfTheProgramsLights) {
  scene::Snapshot s = test::pathView({test::backWall()});
  s.shadings[0].lights.resize(1);
  s.shadings[0].lights[0].position = {0, 0, 1, 0};
  s.shadings[0].lights[0].diffuse = glm::vec4(9);
  s.settings.lights.rig = LightRig::sky;
  s.settings.environment.strength = 5;
  s.settings.path.depth = 1;
  // Half of the wall's sky is the ground, of 0.4.
  EXPECT_NEAR(radiances(s).mean().g, 0.7f, 0.01f);
  s.settings.path.lights = 0.5f;
  EXPECT_NEAR(radiances(s).mean().g, 0.35f, 0.005f);
  s.settings.path.lights = 1, s.settings.lights.rig = LightRig::sun, s.settings.lights.ratio = 4;
  s.settings.lights.azimuth = 0, s.settings.lights.elevation = 30;
  const float sun = 1 / 1.25f;
  EXPECT_NEAR(radiances(s).mean().g, sun * std::cos(glm::radians(30.0f)) + sun / 4 * 0.75f, 0.01f);
}

TEST(PathLights, AnotherEnvironmentTakesThePlaceOfTheRigsSky) {
  scene::Snapshot s = test::pathView({test::backWall()});
  s.settings.lights.rig = LightRig::sky;
  s.settings.environment.kind = EnvironmentKind::gradient;
  s.settings.environment.color = s.settings.environment.horizon = s.settings.environment.ground =
      glm::vec3(0.25f);
  s.settings.path.depth = 1;
  EXPECT_NEAR(radiances(s).mean().g, 0.25f, 1e-4f);
}

}  // namespace
}  // namespace gluray::render
