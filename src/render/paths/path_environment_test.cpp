// Environments in the path tracer: two ways to draw directions together agree with each alone, and with a
// second, plain implementation.
#include "base/sanitized.h"
#include "base/testing/temporary_folder.h"
#include "render/lights/make_environment.h"
#include "render/testing/path_scenes.h"

#include <random>

namespace gluray::render {
namespace {

using test::Radiances;
using test::radiances;

/// A wall under a sky with a sun, and another that stands on it.
scene::Snapshot underSky() {
  scene::Snapshot s =
      test::pathView({test::backWall(), test::parallelogram({3, 0, 200}, {0, 500, 0}, {0, 0, 200})});
  s.settings.environment.kind = EnvironmentKind::sky;
  s.settings.environment.up = {0, 0, 1};
  s.settings.environment.sun = {0.2f, 0.6f, 0.3f};
  for (scene::Instance& instance : s.instances) test::setAlbedo(instance, {0.5f, 0.5f, 0.5f});
  s.camera.clipFromEye = glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 1000.0);
  return s;
}

/// Radiance of the wall at (x, y, 0) by even directions over the hemisphere and no second thoughts.
double byBruteForce(const Environment& sky, double x, int bounces, std::mt19937& random) {
  std::uniform_real_distribution<double> any(0, 1);
  const auto direction = [&](const glm::dvec3& n) {
    const double z = any(random), r = std::sqrt(1 - z * z), a = 2 * M_PI * any(random);
    const glm::dvec3 t = std::abs(n.z) > 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1),
                     b = glm::cross(n, t);
    return r * std::cos(a) * t + r * std::sin(a) * b + z * n;
  };
  glm::dvec3 p(x, 0, 0), n(0, 0, 1);
  double through = 1;
  for (int k = 0; k < bounces; ++k) {
    const glm::dvec3 d = direction(n);
    through *= 0.5 * 2 * glm::dot(n, d);  // albedo/pi * cosine / (1 / 2 pi)
    // The wall x = 3 from the floor to 400, and the floor; both reach farther than any ray here matters.
    if (n.z == 1) {
      const double t = d.x > 0 ? (3 - p.x) / d.x : -1;
      const glm::dvec3 q = p + t * d;
      if (t <= 0 || q.z > 400 || std::abs(q.y) > 500) return through * double{sky.radiance(glm::vec3(d)).g};
      p = {3, q.y, q.z}, n = {-1, 0, 0};
    } else {
      const double t = d.z < 0 ? -p.z / d.z : -1;
      const glm::dvec3 q = p + t * d;
      if (t <= 0 || std::abs(q.x) > 500 || std::abs(q.y) > 500)
        return through * double{sky.radiance(glm::vec3(d)).g};
      p = {q.x, q.y, 0}, n = {0, 0, 1};
    }
  }
  return 0;
}

TEST(PathEnvironment, AgreesWithAPlainImplementation) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = underSky();
  s.settings.path.depth = 4, s.settings.path.samples = 256;
  const auto sky = makeEnvironment(s.settings, glm::dmat4(1));  // in world space
  std::mt19937 random(11);
  std::uniform_real_distribution<double> across(-1, 1);
  double sum = 0, squares = 0;
  constexpr int kPaths = 4'000'000;
  for (int i = 0; i < kPaths; ++i) {
    const double x = across(random), value = byBruteForce(*sky, x, 4, random);
    sum += value, squares += value * value;
  }
  const double mean = sum / kPaths, deviation = std::sqrt((squares / kPaths - mean * mean) / kPaths);
  const double found = double{radiances(s).mean().g};
  EXPECT_LT(deviation, 0.02 * mean);
  EXPECT_NEAR(found, mean, 4 * deviation + 0.005 * mean);
}

TEST(PathEnvironment, AnEvenImageIsAConstantEnvironment) {
  GLURAY_RELEASE_ONLY();
  // Both ways to draw directions are used for the image, one for the constant.
  scene::Snapshot s = test::pathView({test::backWall(), test::ballMesh(40, 1, {0, 0, 1.5f})});
  for (const SurfaceMaterial kind :
       {SurfaceMaterial::program, SurfaceMaterial::plastic, SurfaceMaterial::metal}) {
    s.settings.material.kind = kind;
    s.settings.material.roughness = 0.4f;
    s.settings.environment.kind = EnvironmentKind::constant;
    s.settings.environment.color = glm::vec3(0.5f);
    const glm::vec3 constant = radiances(s).mean();
    std::string even = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    for (int i = 0; i < 8; ++i) even += "\x40\x40\x40\x81";
    const test::TemporaryFolder folder;
    s.settings.environment.kind = EnvironmentKind::image;
    s.settings.environment.file = folder.write("even.hdr", even);
    const glm::vec3 image = radiances(s).mean();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image[c], constant[c], 0.01f * constant[c]) << int(kind);
  }
}

TEST(PathEnvironment, TheSunCastsShadows) {
  scene::Snapshot s = underSky();
  s.settings.path.depth = 1;
  const auto lit = [&](float x) {
    s.settings.environment.sun = {x, 0.5f, 0};
    return radiances(s).mean().g;
  };
  // The wall at x = 3 hides the half where x is positive.
  EXPECT_GT(lit(-1), 1.5f * lit(1));
}

TEST(PathEnvironment, WhittedShowsMirrorsAndEndsAtOtherSurfaces) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  s.settings.integrator = LightIntegrator::whitted;
  test::setAlbedo(s.instances[0], {0.2f, 0.5f, 0.8f});
  const glm::vec3 diffuse = radiances(s).mean();
  EXPECT_NEAR(diffuse.b, 0.8f, 1e-3f);
  for (const SurfaceMaterial kind : {SurfaceMaterial::mirror, SurfaceMaterial::glass}) {
    s.settings.material.kind = kind;
    s.settings.material.roughness = 0;
    s.settings.path.depth = 32;
    test::setAlbedo(s.instances[0], glm::vec3(1));
    EXPECT_NEAR(radiances(s).mean().g, 1, 0.01f) << int(kind);
  }
  // Light from the sky alone, not from the other wall.
  scene::Snapshot walls =
      test::pathView({test::backWall(), test::parallelogram({3, 0, 200}, {0, 500, 0}, {0, 0, 200})});
  walls.settings.integrator = LightIntegrator::whitted;
  EXPECT_NEAR(radiances(walls).mean().g, 0.5f, 0.005f);
}

}  // namespace
}  // namespace gluray::render
