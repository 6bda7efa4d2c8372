// Environments: images of the sky against brute force, files that cannot be read, rotation.
#include "base/testing/temporary_folder.h"
#include "render/lights/make_environment.h"
#include "render/lights/preetham.h"
#include "render/lights/sky_files.h"
#include "render/lights/sky_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#ifdef GLURAY_OPENEXR
#include <ImfRgbaFile.h>
#endif

namespace gluray::render {
namespace {

glm::vec2 pointOf(uint32_t i) {
  // A lattice of rank 1.
  const double x = (i + 0.5) * 0.7548776662466927, y = (i + 0.5) * 0.5698402909980532;
  return {static_cast<float>(x - std::floor(x)), static_cast<float>(y - std::floor(y))};
}

glm::vec3 directionOf(const glm::vec2& u) {
  const float z = 1 - 2 * u.x, r = std::sqrt(std::max(1 - z * z, 0.0f)), a = 6.2831853f * u.y;
  return {r * std::cos(a), z, r * std::sin(a)};
}

/// Dim all over, with one bright spot.
SkyPixels spotted() {
  SkyPixels p{32, 16, std::vector<glm::vec3>(32 * 16, glm::vec3(0.1f))};
  p.pixels[5 * 32 + 20] = {300, 200, 100};
  p.pixels[9 * 32 + 3] = {0, 50, 0};
  return p;
}

TEST(SkyImage, SamplesAndEvenDirectionsGiveTheSameLight) {
  const SkyImage sky(spotted());
  constexpr uint32_t kSamples = 1 << 18;
  glm::dvec3 drawn(0), even(0);
  for (uint32_t i = 0; i < kSamples; ++i) {
    const Environment::Arriving a = sky.sample(pointOf(i));
    ASSERT_GT(a.pdf, 0);
    ASSERT_NEAR(glm::length(a.direction), 1, 1e-5f);
    drawn += glm::dvec3(a.radiance / a.pdf);
    even += glm::dvec3(sky.radiance(directionOf(pointOf(i)))) * 4.0 * M_PI;
  }
  for (int c = 0; c < 3; ++c) {
    const double expected = even[c] / kSamples;
    EXPECT_NEAR(drawn[c] / kSamples, expected, 0.02 * expected) << c;
  }
}

TEST(SkyImage, DensitiesIntegrateToOneAndAreThoseOfSamples) {
  const SkyImage sky(spotted());
  constexpr uint32_t kSamples = 1 << 18;
  double all = 0;
  for (uint32_t i = 0; i < kSamples; ++i)
    all += double{sky.pdf(directionOf(pointOf(i)))} * 4 * M_PI / kSamples;
  EXPECT_NEAR(all, 1, 0.02);
  for (uint32_t i = 0; i < 1000; ++i) {
    const Environment::Arriving a = sky.sample(pointOf(i));
    EXPECT_NEAR(sky.pdf(a.direction), a.pdf, 0.02f * a.pdf) << i;
  }
}

TEST(SkyImage, HoldsWhatIsNoColourToBlackAndHugeOnesToALimit) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInfinite = std::numeric_limits<float>::infinity();
  SkyPixels p{8, 4, std::vector<glm::vec3>(32, glm::vec3(kNan, -1, kInfinite))};
  p.pixels[9] = glm::vec3(1e30f);
  const SkyImage sky(p);
  for (uint32_t i = 0; i < 1000; ++i) {
    const glm::vec3 c = sky.radiance(directionOf(pointOf(i)));
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(c[k] >= 0 && c[k] <= 1e6f);
    EXPECT_TRUE(std::isfinite(sky.sample(pointOf(i)).pdf));
  }
  const SkyImage black(SkyPixels{8, 4, std::vector<glm::vec3>(32, glm::vec3(0))});
  EXPECT_EQ(black.sample({0.5f, 0.5f}).pdf, 0);
  EXPECT_EQ(black.pdf({0, 1, 0}), 0);
}

TEST(Preetham, IsBlueAboveBrightAtTheSunAndNeverBlackByDay) {
  for (const float turbidity : {2.0f, 5.0f, 10.0f})
    for (const float height : {0.0f, 0.2f, 0.7f, 1.0f}) {
      const glm::vec3 sun = glm::normalize(glm::vec3(1, height, 0.3f));
      const SkyImage sky(preethamSky(sun, turbidity, glm::vec3(0.25f)));
      glm::dvec3 level(0);  // irradiance of a level surface
      for (uint32_t i = 0; i < 1 << 16; ++i) {
        const glm::vec3 d = directionOf(pointOf(i)), c = sky.radiance(d);
        for (int k = 0; k < 3; ++k) ASSERT_TRUE(std::isfinite(c[k]) && c[k] >= 0);
        if (d.y > 0) level += glm::dvec3(c) * (double{d.y} * 4 * M_PI / (1 << 16));
      }
      // The sky alone gives about 1, and the sun up to 1.5 more.
      EXPECT_GT(level.g / M_PI, 0.8) << turbidity << ' ' << height;
      EXPECT_LT(level.g / M_PI, 3) << turbidity << ' ' << height;
      EXPECT_EQ(sky.radiance({0, -1, 0}), glm::vec3(0.25f));
    }
  const SkyImage clear(preethamSky({1, 0.7f, 0}, 2.5f, glm::vec3(0)));
  const glm::vec3 north = clear.radiance(glm::normalize(glm::vec3(-1, 1, 0)));
  EXPECT_GT(north.b, north.r);
  EXPECT_GT(clear.radiance(glm::normalize(glm::vec3(1, 0.7f, 0))).g, 20 * north.g);
}

std::string header(int width, int height) {
  return "#?RADIANCE\n# made by a test\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
         std::to_string(width) + "\n";
}

TEST(RadianceFile, PlainAndRunLengthImagesAreRead) {
  // Exponent 129: mantissas / 128.
  const std::string pixel = {'\x80', '\x40', '\x20', '\x81'};
  const SkyPixels plain = readRadiance(header(2, 1) + pixel + std::string{'\0', '\0', '\0', '\0'});
  EXPECT_EQ(plain.pixels[0], glm::vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(plain.pixels[1], glm::vec3(0));
  const SkyPixels repeated = readRadiance(header(4, 1) + pixel + std::string{'\1', '\1', '\1', '\3'});
  EXPECT_EQ(repeated.pixels[3], glm::vec3(1, 0.5f, 0.25f));
  // Eight pixels: red in a run of 8, green in literals, blue in two runs, exponents in a run.
  std::string row = {2, 2, 0, 8, '\x88', '\x80', 8};
  for (int i = 0; i < 8; ++i) row += static_cast<char>(i * 16);
  row += std::string{'\x84', '\x20', '\x84', '\x40', '\x88', '\x81'};
  const SkyPixels runs = readRadiance(header(8, 1) + row);
  EXPECT_EQ(runs.pixels[0], glm::vec3(1, 0, 0.25f));
  EXPECT_EQ(runs.pixels[7], glm::vec3(1, 0.875f, 0.5f));
}

TEST(RadianceFile, BrokenOnesAreRefused) {
  const std::string good = header(8, 1) + std::string{2, 2, 0, 8, '\x88', '\x80'};
  for (const std::string& bad :
       {std::string(), std::string("#?RADIANCE\n"), good, header(8, 1), header(0, 1), header(-5, 3),
        header(2000000000, 2000000000), header(8, 1) + std::string{2, 2, 0, 9, 0, 0, 0},
        header(8, 1) + std::string{2, 2, 0, 8, '\xff', '\x80'}, header(8, 1) + std::string{2, 2, 0, 8, '\0'},
        header(2, 1) + std::string{'\1', '\1', '\1', '\3'},
        std::string("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n")})
    EXPECT_THROW(readRadiance(bad), std::runtime_error) << bad.substr(0, 60);
  // Whatever bytes a file has, it is read or refused.
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string noise = header(8 + static_cast<int>(random() % 9), 3);
    const uint32_t length = random() % 200;
    for (uint32_t k = 0; k < length; ++k) noise += static_cast<char>(random() % 8 == 0 ? 2 : random());
    try {
      readRadiance(noise);
    } catch (const std::runtime_error&) {}
  }
}

/// A file of this test's own, removed at the end.
struct TestFile {
  test::TemporaryFolder folder;
  std::string path;
  explicit TestFile(const std::string& name) : path(folder.file(name)) {}
  void write(const std::string& bytes) const {
    std::ofstream(path, std::ios::binary) << bytes;
    // The next write must have another time.
    static int seconds = 0;
    std::filesystem::last_write_time(
        path, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++seconds));
  }
};

std::string evenImage(char mantissa) {
  std::string bytes = header(4, 2);
  for (int i = 0; i < 8; ++i) bytes += std::string{mantissa, mantissa, mantissa, '\x81'};
  return bytes;
}

TEST(Environment, AImageStaysWhileItsFileCannotBeRead) {
  const TestFile file("gluray_environment_test.hdr");
  file.write(evenImage('\x40'));
  Settings s;
  s.environment.kind = EnvironmentKind::image;
  s.environment.file = file.path;
  s.environment.strength = 2;
  const auto brightness = [&] { return makeEnvironment(s, glm::dmat4(1))->radiance({0, 1, 0}).r; };
  EXPECT_EQ(brightness(), 1);
  file.write("nonsense");
  EXPECT_EQ(brightness(), 1) << "the last good one";
  file.write(evenImage('\x20'));
  EXPECT_EQ(brightness(), 0.5f);
  s.environment.file = "/nowhere/at/all.hdr";
  EXPECT_EQ(brightness(), 0.5f);
}

#ifdef GLURAY_OPENEXR
TEST(Environment, OpenExrImagesAreRead) {
  const TestFile file("gluray_environment_test.exr");
  {
    Imf::Rgba pixels[8];
    for (int i = 0; i < 8; ++i) pixels[i] = Imf::Rgba(0.25f, 0.5f, static_cast<float>(i), 1);
    Imf::RgbaOutputFile out(file.path.c_str(), 4, 2, Imf::WRITE_RGBA);
    out.setFrameBuffer(pixels, 1, 4);
    out.writePixels(2);
  }
  const SkyPixels image = readSkyPixels(file.path);
  ASSERT_EQ(image.width, 4);
  ASSERT_EQ(image.height, 2);
  for (size_t i = 0; i < 8; ++i) EXPECT_EQ(image.pixels[i], glm::vec3(0.25f, 0.5f, static_cast<float>(i)));
  std::ifstream in(file.path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THROW(readOpenExr(bytes.substr(0, bytes.size() / 2)), std::exception);
  EXPECT_THROW(readOpenExr(std::string("\x76\x2f\x31\x01", 4)), std::exception);
}
#endif

TEST(Environment, TurnsWithTheSceneAndByItsRotation) {
  Settings s;
  const auto turned = [&](const glm::dmat4& eyeFromWorld) { return skyFromEye(s, eyeFromWorld); };
  EXPECT_NEAR(glm::dot(turned(glm::dmat4(1)) * glm::vec3(1, 0, 0), glm::vec3(1, 0, 0)), 1, 1e-6f);
  // A world that is turned and scaled keeps its up, and the map stays a rotation.
  const glm::dmat4 world(glm::dvec4(0, 3, 0, 0), glm::dvec4(0, 0, 5, 0), glm::dvec4(7, 0, 0, 0),
                         glm::dvec4(1, 2, 3, 1));
  const glm::mat3 m = turned(world);
  EXPECT_NEAR(glm::determinant(m), 1, 1e-5f);
  EXPECT_NEAR((m * glm::vec3(0, 0, 1)).y, 1, 1e-6f) << "world y is eye z";
  s.environment.rotation = 90;
  const glm::vec3 x = turned(glm::dmat4(1)) * glm::vec3(1, 0, 0);
  EXPECT_NEAR(std::abs(x.z), 1, 1e-6f);
  EXPECT_NEAR(x.y, 0, 1e-6f);
  s.environment.up = {0, 0, 1};
  EXPECT_NEAR((turned(glm::dmat4(1)) * glm::vec3(0, 0, 1)).y, 1, 1e-6f);
}

TEST(Environment, AGradientHasItsThreeColours) {
  Settings s;
  s.environment.kind = EnvironmentKind::gradient;
  s.environment.strength = 1;
  s.environment.color = {0, 0, 1}, s.environment.horizon = {0, 1, 0}, s.environment.ground = {1, 0, 0};
  const auto environment = makeEnvironment(s, glm::dmat4(1));
  EXPECT_EQ(environment->radiance({0, 1, 0}), glm::vec3(0, 0, 1));
  EXPECT_EQ(environment->radiance({1, 0, 0}), glm::vec3(0, 1, 0));
  EXPECT_EQ(environment->radiance({0, -1, 0}), glm::vec3(1, 0, 0));
}

TEST(Environment, AStudioTurnsWithTheCameraAndIsOnAverageAsBrightAsAConstantOne) {
  Settings s;
  s.environment.kind = EnvironmentKind::studio;
  s.environment.strength = 1;
  const glm::dmat4 turned(glm::dvec4(0, 3, 0, 0), glm::dvec4(0, 0, 5, 0), glm::dvec4(7, 0, 0, 0),
                          glm::dvec4(1, 2, 3, 1));
  const auto environment = makeEnvironment(s, glm::dmat4(1)), elsewhere = makeEnvironment(s, turned);
  constexpr uint32_t kDirections = 1 << 16;
  double sum = 0;
  for (uint32_t i = 0; i < kDirections; ++i) {
    const glm::vec3 d = directionOf(pointOf(i)), light = environment->radiance(d);
    ASSERT_EQ(light, elsewhere->radiance(d)) << "the studio must not turn with the scene";
    sum += double{light.x};
  }
  EXPECT_NEAR(sum / kDirections, 1, 0.01);
  EXPECT_TRUE(environment->isSampled());
}

TEST(Environment, AStudioHasBrightBoxesBetweenDarkWallsAndTurnsByItsRotation) {
  Settings s;
  s.environment.kind = EnvironmentKind::studio;
  s.environment.strength = 1;
  const auto from = [&](float azimuth, float elevation) {
    const float a = glm::radians(azimuth), e = glm::radians(elevation);
    return makeEnvironment(s, glm::dmat4(1))
        ->radiance({std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)})
        .x;
  };
  EXPECT_GT(from(-68, 12), 3 * from(0, -30)) << "left of the viewer, and below";
  EXPECT_GT(from(-20, 62), 3 * from(0, 0)) << "above, and behind the camera";
  EXPECT_GT(from(62, 8), 2 * from(100, 0));
  const float left = from(-68, 12);
  s.environment.rotation = 90;
  EXPECT_FLOAT_EQ(std::max(from(-68 + 90, 12), from(-68 - 90, 12)), left);
  EXPECT_LT(from(-68, 12), left);
}

}  // namespace
}  // namespace gluray::render
