// Lights of files: their brightness and shadows against integrals computed plainly.
#include "render/testing/lit_wall.h"
#include "render/testing/test_light_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace gluray::render {
namespace {

using test::kLitSize;
using test::LightFile;
using test::Shader;
using test::Traced;

/// The wall near the origin and a screen at z = 2 from x = 0.05 on, just outside the view, without lights of
/// their own.
scene::Snapshot narrowView(Shader shader, const LightFile& file, bool screened) {
  std::vector<scene::MeshPtr> meshes{test::wall()};
  if (screened) meshes.push_back(test::parallelogram({10.05f, 0, 2}, {10, 0, 0}, {0, 50, 0}));
  scene::Snapshot s = test::litView(meshes, shader, {0, 0, 1, 0});
  s.shadings[0].lights.clear(), s.shadings[0].fragment.lights.clear();
  s.camera.clipFromEye = glm::perspective(glm::radians(0.5), 1.0, 0.1, 1000.0);
  s.settings.lights.file = file.name;
  s.settings.shadows.samples = 256;
  return s;
}

float meanOf(const Traced& traced) {
  float sum = 0;
  for (int y = 0; y < kLitSize; ++y)
    for (int x = 0; x < kLitSize; ++x) sum += traced.color(x, y).g / 255;
  return sum / (kLitSize * kLitSize);
}

/// The share of what an area sends to the origin of the wall that passes the screen. `sample` gives points of
/// the area and its normals there.
float passingShare(const std::function<std::pair<glm::dvec3, glm::dvec3>(double, double)>& sample) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  double passing = 0, all = 0;
  for (int i = 0; i < 200000; ++i) {
    const double u = number(random), v = number(random);
    const auto [point, normal] = sample(u, v);
    const double distance = glm::length(point);
    const double weight =
        std::max(point.z, 0.0) * std::max(-glm::dot(normal, point), 0.0) / std::pow(distance, 4);
    all += weight;
    if (point.x / point.z * 2 < 0.05) passing += weight;
  }
  return static_cast<float>(passing / all);
}

TEST(AddedLights, ADiscShinesAsItsFormFactor) {
  const LightFile file(
      "[[light]]\nkind = 'disc'\nposition = [0, 0, 3]\ntarget = [0, 0, 0]\nradius = 2\nstrength = 0.9\n");
  for (const Shader shader : {Shader::fixedFunction, Shader::phong})
    EXPECT_NEAR(meanOf(test::trace(narrowView(shader, file, false))), 0.9f * 4 / (4 + 9), 0.003f);
}

TEST(AddedLights, ASphereShinesAsItsFormFactor) {
  const LightFile file("[[light]]\nkind = 'sphere'\nposition = [0, 0, 4]\nradius = 2\n");
  for (const Shader shader : {Shader::fixedFunction, Shader::phong})
    EXPECT_NEAR(meanOf(test::trace(narrowView(shader, file, false))), 0.25f, 0.003f);
}

TEST(AddedLights, HalfHiddenRectanglesShineHalf) {
  const LightFile file(
      "[[light]]\nkind = 'rectangle'\nposition = [0.3, 0.2, 4]\ndirection = [0, 0, -2]\nwidth = 3\nheight = "
      "2\n");
  const float wanted = passingShare([](double u, double v) {
    return std::pair(glm::dvec3(0.3 + 3 * (u - 0.5), 0.2 + 2 * (v - 0.5), 4), glm::dvec3(0, 0, -1));
  });
  EXPECT_GT(wanted, 0.3f);
  EXPECT_LT(wanted, 0.6f);
  for (const Shader shader : {Shader::fixedFunction, Shader::phong}) {
    const float open = meanOf(test::trace(narrowView(shader, file, false)));
    EXPECT_NEAR(meanOf(test::trace(narrowView(shader, file, true))) / open, wanted, 0.01f);
  }
}

TEST(AddedLights, DiscsAreHiddenAsFarAsTheyAreBehindTheScreen) {
  const LightFile file(
      "[[light]]\nkind = 'disc'\nposition = [-0.5, 0, 4]\ntarget = [1, 0, 0]\nradius = 1.5\n");
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.5, 0, -4)),
                   across = glm::cross(normal, glm::dvec3(0, 1, 0));
  const float wanted = passingShare([&](double u, double v) {
    const double r = 1.5 * std::sqrt(u), a = 2 * M_PI * v;
    return std::pair(glm::dvec3(-0.5, 0, 4) + r * (std::cos(a) * across + std::sin(a) * glm::dvec3(0, 1, 0)),
                     normal);
  });
  const float open = meanOf(test::trace(narrowView(Shader::phong, file, false)));
  EXPECT_NEAR(meanOf(test::trace(narrowView(Shader::phong, file, true))) / open, wanted, 0.01f);
}

TEST(AddedLights, SpheresAreHiddenAsFarAsTheyAreBehindTheScreen) {
  const LightFile file("[[light]]\nkind = 'sphere'\nposition = [0.4, 0, 4]\nradius = 1\n");
  const float wanted = passingShare([&](double u, double v) {
    const double z = 2 * u - 1, r = std::sqrt(1 - z * z), a = 2 * M_PI * v;
    const glm::dvec3 n(r * std::cos(a), r * std::sin(a), z);
    return std::pair(glm::dvec3(0.4, 0, 4) + n, n);
  });
  const float open = meanOf(test::trace(narrowView(Shader::phong, file, false)));
  EXPECT_NEAR(meanOf(test::trace(narrowView(Shader::phong, file, true))) / open, wanted, 0.01f);
}

TEST(AddedLights, SpotsLightTheirCone) {
  const LightFile file("[[light]]\nkind = 'spot'\nposition = [0, 0, 3]\ndirection = [0, 0, -1]\ncone = 20\n");
  for (const Shader shader : {Shader::fixedFunction, Shader::phong}) {
    scene::Snapshot s = narrowView(shader, file, false);
    s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
    const Traced traced = test::trace(s);
    const float rim = 3 * std::tan(glm::radians(20.0f)), y = test::wallAt(kLitSize / 2);
    for (int x = 0; x < kLitSize; ++x) {
      const float from = std::hypot(test::wallAt(x), y);
      if (std::abs(from - rim) > 1e-3f) { EXPECT_EQ(traced.color(x, kLitSize / 2).g > 0, from < rim) << x; }
    }
  }
}

TEST(AddedLights, StandInTheSceneOrMoveWithTheCamera) {
  const LightFile scene("[[light]]\nkind = 'distant'\ndirection = [-1, 0, 0]\n"),
      camera("[[light]]\nkind = 'distant'\ndirection = [-1, 0, 0]\nspace = 'camera'\n");
  const auto brightness = [](const LightFile& file) {
    scene::Snapshot s = narrowView(Shader::fixedFunction, file, false);
    // The wall turned by 60 degrees to the right.
    s.eyeFromWorld = s.eyeFromWorld * glm::rotate(glm::dmat4(1), glm::radians(60.0), glm::dvec3(0, 1, 0));
    for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld;
    return meanOf(test::trace(s));
  };
  EXPECT_EQ(brightness(scene), 0) << "it grazes the wall";
  EXPECT_NEAR(brightness(camera), std::sin(glm::radians(60.0f)), 0.003f);
}

TEST(AddedLights, ShineBesideTheProgramsOwn) {
  const LightFile file(
      "[[light]]\nkind = 'distant'\ndirection = [0, 0, -1]\nstrength = 0.25\ncolor = [0, 1, 0]\n");
  scene::Snapshot s = narrowView(Shader::fixedFunction, file, false);
  test::setLight(s, Shader::fixedFunction, {0, 0, 1, 0});
  s.shadings[0].lights[0].diffuse = glm::vec4(0.5f);
  EXPECT_LE(test::difference(test::trace(s).color(5, 5), {127.5f, 191.25f, 127.5f, 255}), 1);
}

TEST(AddedLights, OfABadFileAreTheLastGoodOnes) {
  const LightFile file("[[light]]\nkind = 'distant'\ndirection = [0, 0, -1]\nstrength = 0.5\n");
  EXPECT_NEAR(meanOf(test::trace(narrowView(Shader::phong, file, false))), 0.5f, 0.003f);
  file.write("[[light]]\nkind = 'distant'\ndirection = [0, 0, 0]\nstrength = 0.75\n");
  EXPECT_NEAR(meanOf(test::trace(narrowView(Shader::phong, file, false))), 0.5f, 0.003f);
  file.write("[[light]]\nkind = 'distant'\ndirection = [0, 0, -1]\nstrength = 0.125\n");
  EXPECT_NEAR(meanOf(test::trace(narrowView(Shader::phong, file, false))), 0.125f, 0.003f);
}

}  // namespace
}  // namespace gluray::render
