// Lights that can be seen, where and in front of what.
#include "render/testing/path_scenes.h"
#include "render/testing/test_light_file.h"

#include <gtest/gtest.h>

namespace gluray::render {
namespace {

using test::kPathSize;
using test::LightFile;
using test::Radiances;
using test::radiances;

/// A white wall at z = 0 that fills the left half of the view (x < 0). Camera at z = 5, 40 degrees.
scene::Snapshot halfWall(const std::string& file, bool paths) {
  scene::Snapshot s = test::pathView({test::parallelogram({-50, 0, 0}, {50, 0, 0}, {0, 50, 0})});
  s.settings.integrator = paths ? LightIntegrator::path : LightIntegrator::local;
  s.settings.path.samples = 4;
  s.settings.lights.file = file;
  return s;
}

/// The window depth of the point (0, 0, z) of that view.
float depthOf(float z) {
  const glm::dvec4 clip = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0) * glm::dvec4(0, 0, z - 5, 1);
  return static_cast<float>(0.5 + 0.5 * clip.z / clip.w);
}

bool isGreen(const Radiances& p, int x, int y) {
  return p.hit(x, y) && glm::length(p.at(x, y) - glm::vec3(0, 3, 0)) < 1e-4f;
}

constexpr char kGreen[] = "color = [0, 1, 0]\nstrength = 3\nvisible = true\n";
constexpr int kMiddle = kPathSize / 2;

TEST(Lamps, AreSeenAtTheirPlaceAndDepth) {
  for (const bool paths : {false, true}) {
    const LightFile file(std::string("[[light]]\nkind = 'sphere'\nposition = [0, 0, 1]\nradius = 0.5\n") +
                         kGreen);
    const Radiances image = radiances(halfWall(file.name, paths));
    EXPECT_NEAR(image.traced.depth(kMiddle, kMiddle), depthOf(1.5f), 2e-4f);
    // The rim of a ball of radius 0.5 at distance 4.
    const float rim = std::tan(std::asin(0.5f / 4)) / std::tan(glm::radians(20.0f)) * kMiddle;
    for (int y = 0; y < kPathSize; ++y)
      for (int x = 0; x < kPathSize; ++x) {
        const float from = std::hypot(float(x - kMiddle) + 0.5f, float(y - kMiddle) + 0.5f);
        EXPECT_EQ(isGreen(image, x, y), from < rim) << x << ',' << y;
      }
    EXPECT_TRUE(image.hit(0, 0));
    EXPECT_FALSE(image.hit(kPathSize - 1, 0)) << "nothing is there";
  }
}

TEST(Lamps, AreHiddenBySurfacesBeforeThem) {
  const LightFile file(
      std::string("[[light]]\nkind = 'disc'\nposition = [0, 0, -1]\ndirection = [0, 0, 1]\n") + kGreen);
  for (const bool paths : {false, true}) {
    const Radiances image = radiances(halfWall(file.name, paths));
    EXPECT_FALSE(isGreen(image, kMiddle - 1, kMiddle));
    EXPECT_TRUE(isGreen(image, kMiddle, kMiddle));
    EXPECT_NEAR(image.traced.depth(kMiddle, kMiddle), depthOf(-1), 1e-5f);
  }
}

TEST(Lamps, ShowTheirFrontAlone) {
  for (const char* kind : {"disc", "rectangle"}) {
    const LightFile file("[[light]]\nkind = '" + std::string(kind) +
                         "'\nposition = [0, 0, 1]\ndirection = [0, 0, -1]\n" + kGreen);
    const Radiances image = radiances(halfWall(file.name, false));
    EXPECT_FALSE(isGreen(image, kMiddle - 1, kMiddle));
    EXPECT_FALSE(image.hit(kMiddle, kMiddle));
  }
}

TEST(Lamps, AreSeenBeforeTheNearPlaneAndBeyondTheFarOne) {
  for (const float z : {4.95f, -2000.0f}) {
    const LightFile file("[[light]]\nkind = 'rectangle'\nposition = [0, 0, " + std::to_string(z) +
                         "]\ndirection = [0, 0, 1]\nwidth = 1e4\nheight = 1e4\n" + kGreen);
    const Radiances image = radiances(halfWall(file.name, false));
    EXPECT_EQ(isGreen(image, 0, 0), z > 0);
    EXPECT_TRUE(isGreen(image, kPathSize - 1, 0));
    const float depth = image.traced.depth(kPathSize - 1, 0);
    EXPECT_EQ(depth == 0, z > 0) << depth;
    EXPECT_LT(depth, 1) << "in front of what the framebuffer is cleared to";
  }
}

TEST(Lamps, DistantOnesAreDiscsBehindEverything) {
  const LightFile file(std::string("[[light]]\nkind = 'distant'\ndirection = [0, 0, 1]\nangle = 10\n") +
                       kGreen);
  const Radiances image = radiances(halfWall(file.name, false));
  const float rim = std::tan(glm::radians(5.0f)) / std::tan(glm::radians(20.0f)) * kMiddle;
  for (int x = 0; x < kPathSize; ++x) {
    const float from = std::hypot(float(x - kMiddle) + 0.5f, 0.5f);
    EXPECT_EQ(isGreen(image, x, kMiddle), x >= kMiddle && from < rim) << x;
  }
}

TEST(Lamps, InvisibleOnesAreNotSeen) {
  for (const bool paths : {false, true}) {
    const LightFile file("[[light]]\nkind = 'sphere'\nposition = [1, 0, 1]\nradius = 0.5\n");
    const Radiances image = radiances(halfWall(file.name, paths));
    for (int x = kMiddle; x < kPathSize; ++x) EXPECT_FALSE(image.hit(x, kMiddle));
  }
}

TEST(Lamps, ShareThePixelsOfTheirRims) {
  const LightFile file(std::string("[[light]]\nkind = 'sphere'\nposition = [0, 0, 1]\nradius = 0.5\n") +
                       kGreen);
  scene::Snapshot s = halfWall(file.name, false);
  const auto green = [&] {
    const Radiances p = radiances(s);
    double sum = 0;
    for (int y = 0; y < kPathSize; ++y)
      for (int x = kMiddle; x < kPathSize; ++x)
        if (p.hit(x, y)) sum += p.at(x, y).g;
    return sum;
  };
  const float rim = std::tan(std::asin(0.5f / 4)) / std::tan(glm::radians(20.0f)) * kMiddle;
  s.settings.spp = 64;
  EXPECT_NEAR(green(), 3 * M_PI / 2 * rim * rim, 1);
}

TEST(Lamps, AreSeenInParallelViewsFromThePlaneOfTheEye) {
  for (const float z : {4.0f, 6.0f}) {
    const LightFile file("[[light]]\nkind = 'sphere'\nposition = [1, 0, " + std::to_string(z) +
                         "]\nradius = 0.5\n" + kGreen);
    scene::Snapshot s = halfWall(file.name, false);
    s.camera.clipFromEye = glm::ortho(-2.0, 2.0, -2.0, 2.0, 2.0, 100.0);
    const Radiances image = radiances(s);
    for (int x = 0; x < kPathSize; ++x) {
      const float at = (float(x) + 0.5f - kMiddle) / kMiddle * 2, y = 0.5f / kMiddle * 2;
      EXPECT_EQ(isGreen(image, x, kMiddle), z < 5 && std::hypot(at - 1, y) < 0.5f) << x;
    }
  }
}

TEST(Lamps, ImagesToPickFromHaveNone) {
  const LightFile file(std::string("[[light]]\nkind = 'sphere'\nposition = [1, 0, 1]\nradius = 0.5\n") +
                       kGreen);
  scene::Snapshot s = halfWall(file.name, false);
  s.shadings[0].lighting = false;
  const Radiances image = radiances(s);
  for (int x = kMiddle; x < kPathSize; ++x) EXPECT_FALSE(image.hit(x, kMiddle));
}

}  // namespace
}  // namespace gluray::render
