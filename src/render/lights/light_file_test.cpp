#include "render/lights/light_file.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::render {
namespace {

using Kind = scene::LightSource::Kind;

std::string errorOf(const std::string& text) {
  try {
    parseLights(text, "lights.toml");
  } catch (const LightFileError& e) { return e.what(); }
  return "";
}

TEST(LightFile, DescribesEveryKind) {
  const auto lights = parseLights(R"(
[[light]]
kind = "distant"
direction = [0, -2, 0]
angle = 0.53
color = [1, 0.9, 0.8]
strength = 2
[[light]]
kind = "spot"
position = [0, 4, 0]
target = [0, 0, 0]
cone = 60
exponent = 3
space = "camera"
[[light]]
kind = "point"
position = [1, 2, 3]
radius = 0.5
attenuation = [0, 0, 1]
[[light]]
kind = "rectangle"
position = [0, 0, 4]
direction = [0, 0, -1]
width = 4
height = 2
[[light]]
kind = "disc"
position = [0, 0, 4]
direction = [0, 0, -1]
radius = 2
visible = false
[[light]]
kind = "sphere"
position = [0, 0, 4]
radius = 3
)",
                                  "lights.toml");
  ASSERT_EQ(lights.size(), 6u);
  EXPECT_EQ(lights[0].light.direction, glm::vec3(0, -1, 0));
  EXPECT_EQ(lights[0].light.angle, 0.53f);
  EXPECT_EQ(lights[0].light.color, glm::vec3(1, 0.9f, 0.8f));
  EXPECT_EQ(lights[0].light.strength, 2);
  EXPECT_FALSE(lights[0].onCamera);
  EXPECT_EQ(lights[1].light.kind, Kind::spot);
  EXPECT_EQ(lights[1].light.direction, glm::vec3(0, -1, 0));
  EXPECT_NEAR(lights[1].light.coneCosine, 0.5f, 1e-6f);
  EXPECT_EQ(lights[1].light.coneExponent, 3);
  EXPECT_TRUE(lights[1].onCamera);
  EXPECT_EQ(lights[2].light.radius, 0.5f);
  EXPECT_EQ(lights[2].light.attenuation, glm::vec3(0, 0, 1));
  EXPECT_EQ(glm::abs(lights[3].light.halfEdge[0]), glm::vec3(2, 0, 0));
  EXPECT_EQ(glm::abs(lights[3].light.halfEdge[1]), glm::vec3(0, 1, 0));
  EXPECT_EQ(lights[4].light.kind, Kind::disc);
  EXPECT_EQ(lights[5].light.radius, 3);
}

TEST(LightFile, ErrorsNameTheLineAndWhatToDo) {
  EXPECT_EQ(errorOf("\n[[light]]\ndirection = [0, 0, 1]\n"), "lights.toml:2: needs a kind");
  EXPECT_EQ(errorOf("[[light]]\nkind = 'lamp'\n"),
            "lights.toml:2: kind must be one of distant, point, spot, rectangle, disc, sphere");
  EXPECT_EQ(errorOf("[[light]]\nkind = 'point'\n"), "lights.toml:1: needs a position");
  EXPECT_EQ(errorOf("[[light]]\nkind = 'distant'\ndirection = [0, 0]\n"),
            "lights.toml:3: direction must be three numbers");
  EXPECT_EQ(errorOf("[[light]]\nkind = 'distant'\ndirection = [0, 0, nan]\n"),
            "lights.toml:3: direction must be numbers from -1e+30 to 1e+30");
  EXPECT_EQ(errorOf("[[light]]\nkind = 'distant'\ndirection = [0, 0, 1]\nstrength = -1\n"),
            "lights.toml:4: strength must be numbers from 0 to 1e+06");
  EXPECT_EQ(errorOf("[[light]]\nkind = 'distant'\ndirection = [0, 0, 1]\nradius = 1\n"),
            "lights.toml:4: this kind of light has no radius");
  EXPECT_EQ(errorOf("[[light]]\nkind = 'sphere'\nposition = [0, 0, 1]\nvisible = 1\n"),
            "lights.toml:4: visible must be true or false");
  EXPECT_EQ(errorOf("[light]\nkind = 'sphere'\n"), "lights.toml:1: only tables [[light]] may stand here");
  EXPECT_NE(errorOf("[[light]]\nkind = \n").find("lights.toml:2: "), std::string::npos);
}

TEST(LightFile, EveryBrokenTextIsAnErrorAndNothingElse) {
  const std::string good =
      "[[light]]\nkind = 'spot'\nposition = [0, 4, 0]\ntarget = [0, 0, 0]\ncone = 60\ncolor = [1, 1, 1]\n";
  for (size_t i = 0; i < good.size(); ++i)
    for (const char c : {'\0', '[', '\'', '9', 'e', '\n', '='}) {
      std::string broken = good;
      broken[i] = c;
      errorOf(broken);
      errorOf(good.substr(0, i));
    }
}

TEST(LightFile, LightsOfTheSceneMoveWithIt) {
  const auto lights = parseLights(
      "[[light]]\nkind='sphere'\nposition=[1,0,0]\nradius=2\n[[light]]\nkind='sphere'\nspace='camera'\n"
      "position=[1,0,0]\nradius=2\n",
      "lights.toml");
  const glm::dmat4 m = glm::scale(glm::translate(glm::dmat4(1), {0, 0, -5}), glm::dvec3(3));
  EXPECT_EQ(placed(lights[0], m).position, glm::vec3(3, 0, -5));
  EXPECT_FLOAT_EQ(placed(lights[0], m).radius, 6);
  EXPECT_EQ(placed(lights[1], m), lights[1].light);
}

}  // namespace
}  // namespace gluray::render
