// Path tracing against scenes whose light is known in closed form.
#include "base/sanitized.h"
#include "render/testing/path_scenes.h"

namespace gluray::render {
namespace {

using test::Radiances;
using test::radiances;

void expectAll(const Radiances& image, const glm::vec3& color, float tolerance) {
  for (int y = 0; y < test::kPathSize; ++y)
    for (int x = 0; x < test::kPathSize; ++x)
      if (image.hit(x, y)) {
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(image.at(x, y)[c], color[c], tolerance) << x << ',' << y;
      }
}

TEST(Path, AWhiteSurfaceUnderAWhiteSkyIsWhite) {
  scene::Snapshot s = test::pathView({test::backWall()});
  s.settings.path.samples = 4;
  expectAll(radiances(s), glm::vec3(1), 1e-5f);
}

TEST(Path, AConvexBodyUnderAnEvenSkyHasItsAlbedo) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  test::setAlbedo(s.instances[0], {0.2f, 0.5f, 0.8f});
  expectAll(radiances(s), {0.2f, 0.5f, 0.8f}, 1e-4f);
}

TEST(Path, WhiteSurfacesOfAnyShapeVanishInAWhiteSky) {
  // Light is lost only where paths end at their greatest depth.
  scene::Snapshot s = test::pathView({test::backWall(), test::ballMesh(40, 1, {0, 0, 1.5f}),
                                      test::parallelogram({-1, 0, 1}, {0, 1, 0}, {0, 0, 1})});
  s.settings.path.depth = 64;
  const Radiances image = radiances(s);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.mean()[c], 1, 0.005f);
}

TEST(Path, DirectSkyIsAmbientOcclusion) {
  scene::Snapshot s =
      test::pathView({test::backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})});
  s.settings.path.depth = 1;
  const glm::vec3 direct = radiances(s).mean();
  EXPECT_NEAR(direct.g, 0.5f, 0.004f);
  for (scene::Instance& instance : s.instances) test::setAlbedo(instance, glm::vec3(1));
  s.settings.integrator = LightIntegrator::ao;
  s.settings.ao.radius = 1e6f;
  s.settings.ao.samples = 256;
  s.shadings[0].globalAmbient = glm::vec4(1);
  for (scene::Instance& instance : s.instances)
    instance.materials[0].front.ambient = instance.materials[0].back.ambient = glm::vec4(1);
  EXPECT_NEAR(direct.g, radiances(s).mean().g, 0.004f);
}

TEST(Path, TwoPlanesGiveEachOtherTheirGeometricSeries) {
  GLURAY_RELEASE_ONLY();
  // Between endless walls at x = -1 and x = 1 that emit e, radiance is e / (1 - albedo) everywhere.
  scene::Snapshot s = test::pathView({test::parallelogram({-1, 0, 0}, {0, 5e4f, 0}, {0, 0, 5e4f}),
                                      test::parallelogram({1, 0, 0}, {0, 5e4f, 0}, {0, 0, 5e4f})});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 64;
  s.settings.path.samples = 1024;
  for (scene::Instance& instance : s.instances) {
    test::setAlbedo(instance, {0.2f, 0.5f, 0.7f});
    instance.materials[0].front.emission = instance.materials[0].back.emission = {1, 1, 1, 1};
  }
  const glm::vec3 mean = radiances(s).mean();
  EXPECT_NEAR(mean.r, 1 / (1 - 0.2f), 0.01f);
  EXPECT_NEAR(mean.g, 1 / (1 - 0.5f), 0.01f);
  EXPECT_NEAR(mean.b, 1 / (1 - 0.7f), 0.02f);
}

TEST(Path, InsideAClosedBallLightIsTheGeometricSeries) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = test::pathView({test::ballMesh(60, 50)});
  s.settings.environment.strength = 7;  // does not get in
  s.settings.path.depth = 64;
  test::setAlbedo(s.instances[0], {0, 0.5f, 0.7f});
  s.instances[0].materials[0].front.emission = s.instances[0].materials[0].back.emission = {1, 1, 1, 1};
  const glm::vec3 mean = radiances(s).mean();
  EXPECT_NEAR(mean.r, 1, 1e-4f);
  EXPECT_NEAR(mean.g, 2, 0.01f);
  EXPECT_NEAR(mean.b, 1 / 0.3f, 0.03f);
}

/// The same scene by the localLook look.
scene::Snapshot localLook(scene::Snapshot s) {
  s.settings.integrator = LightIntegrator::local;
  return s;
}

void expectEqualImages(const Radiances& a, const Radiances& b, float tolerance) {
  for (int y = 0; y < test::kPathSize; ++y)
    for (int x = 0; x < test::kPathSize; ++x) {
      ASSERT_EQ(a.hit(x, y), b.hit(x, y));
      if (a.hit(x, y)) {
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(a.at(x, y)[c], b.at(x, y)[c], tolerance) << x << ',' << y << ' ' << c;
      }
    }
}

scene::Light lightAt(const glm::vec4& position, const glm::vec3& color) {
  scene::Light light;
  light.position = position;
  light.diffuse = glm::vec4(color, 1);
  return light;
}

TEST(Path, WithoutBouncesAndSkyItIsTheLocalLookOfDiffuseSurfaces) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1, s.settings.path.samples = 64;
  s.shadings[0].globalAmbient = {0, 0, 0, 1};
  s.shadings[0].normalize = true;
  test::setAlbedo(s.instances[0], {0.9f, 0.5f, 0.25f});
  s.instances[0].materials[0].front.ambient = {0, 0, 0, 1};
  s.shadings[0].lights = {lightAt({0, 0, 1, 0}, {0.5f, 0.6f, 0.7f})};
  expectEqualImages(radiances(s), radiances(localLook(s)), 2e-3f);
  scene::Light lamp = lightAt({0, 0, 0, 1}, {0.9f, 0.9f, 0.9f});  // at the viewer, with a cone
  lamp.attenuation = {0.5f, 0.1f, 0.01f};
  lamp.spotCutoff = 8, lamp.spotExponent = 3;
  s.shadings[0].lights = {lamp};
  expectEqualImages(radiances(s), radiances(localLook(s)), 2e-3f);
}

TEST(Path, PhongSurfacesOfProgramsAreAsBrightAsTheirLocalLook) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1, s.settings.path.samples = 64;
  s.shadings[0].fragment.model = scene::FragmentShading::Model::phong;
  s.shadings[0].fragment.lights.resize(1);
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
  s.instances[0].materials[0].front.ambient = {0.1f, 0, 0.2f, 1};
  s.instances[0].materials[0].front.diffuse = {0.5f, 0.6f, 0.7f, 1};
  expectEqualImages(radiances(s), radiances(localLook(s)), 2e-3f);
}

// A program whose only light is at the viewer gives its normals' matrix alone.
TEST(Path, LightsAtTheViewerTurnWithTheNormalsOfPrograms) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1, s.settings.path.samples = 64;
  s.shadings[0].fragment.model = scene::FragmentShading::Model::phong;
  s.shadings[0].fragment.lights.resize(1);
  s.shadings[0].fragment.lights[0].kind = scene::FragmentLight::headlight;
  s.instances[0].materials[0].front.ambient = {0, 0, 0, 1};
  s.instances[0].lightingFromObject = glm::mat4(1);
  for (const glm::dvec3 axis : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(1, 2, 3)}) {
    s.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), 1.8, glm::normalize(axis));
    s.instances[0].eyeFromObject = s.eyeFromWorld;
    s.instances[0].normalMatrix = glm::mat3(s.eyeFromWorld);
    const auto lit = radiances(s);
    expectEqualImages(lit, radiances(localLook(s)), 2e-3f);
    EXPECT_GT(lit.at(16, 16).g, 0.95f) << "what faces the viewer is lit";
  }
}

TEST(Path, HighlightsAreThoseOfTheLocalLook) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1, s.settings.path.samples = 64;
  s.shadings[0].globalAmbient = {0, 0, 0, 1};
  s.shadings[0].normalize = true;
  scene::Material& m = s.instances[0].materials[0].front;
  m.diffuse = {0.4f, 0.3f, 0.2f, 1}, m.specular = {0.5f, 0.4f, 0.3f, 1}, m.shininess = 12;
  s.shadings[0].lights = {lightAt({0.3f, 0.2f, 1, 0}, glm::vec3(0.8f))};
  s.shadings[0].lights[0].specular = {0.6f, 0.7f, 0.8f, 1};
  for (const bool localViewer : {false, true}) {
    s.shadings[0].localViewer = localViewer;
    expectEqualImages(radiances(s), radiances(localLook(s)), 3e-3f);
  }
  s.shadings[0].fragment.model = scene::FragmentShading::Model::phong;
  s.shadings[0].fragment.lights.resize(1);
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
  m.ambient = {0, 0, 0, 1};
  using Light = scene::FragmentLight;
  for (const auto kind : {Light::headlight, Light::directional})
    for (const auto specular :
         {scene::FragmentShading::Specular::half, scene::FragmentShading::Specular::reflect}) {
      s.shadings[0].fragment.lights[0].kind = kind;
      s.shadings[0].fragment.specular = specular;
      expectEqualImages(radiances(s), radiances(localLook(s)), 3e-3f);
    }
  s.shadings[0].fragment.color = scene::FragmentShading::Color::vertices;
  s.instances[0].color = {0.2f, 0.5f, 0.9f, 1};
  using HighlightColor = scene::FragmentShading::HighlightColor;
  for (const auto color : {HighlightColor::base, HighlightColor::complement}) {
    s.shadings[0].fragment.highlightColor = color;
    expectEqualImages(radiances(s), radiances(localLook(s)), 3e-3f);
  }
}

TEST(Path, VtksPhysicallyBasedSurfacesAreAsBrightAsTheirLocalLook) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1, s.settings.path.samples = 64;
  s.shadings[0].fragment.model = scene::FragmentShading::Model::pbr;
  s.shadings[0].fragment.lights.resize(1);
  s.shadings[0].fragment.lights[0].color = glm::vec3(3);
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
  s.instances[0].materials[0].front.diffuse = {0.7f, 0.5f, 0.3f, 1};
  s.shadings[0].fragment.pbr.emissive = {0.1f, 0.05f, 0};
  for (const float metallic : {0.0f, 0.5f, 1.0f})
    for (const float roughness : {0.2f, 0.5f, 0.9f}) {
      s.shadings[0].fragment.pbr.metallic = metallic, s.shadings[0].fragment.pbr.roughness = roughness;
      expectEqualImages(radiances(s), radiances(localLook(s)), 6e-3f);
    }
}

TEST(Path, LightsAreHiddenBySurfacesInTheirWay) {
  scene::Snapshot s =
      test::pathView({test::backWall(), test::parallelogram({100, 0, 100}, {0, 90, 0}, {0, 0, 90})});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1;
  s.shadings[0].lights = {lightAt({1, 0, 1, 0}, glm::vec3(1))};
  EXPECT_NEAR(radiances(s).mean().r, 0, 1e-6f);
  s.shadings[0].lights = {lightAt({-1, 0, 1, 0}, glm::vec3(1))};
  EXPECT_NEAR(radiances(s).mean().r, std::sqrt(0.5f), 1e-5f);
}

TEST(Path, IsTheSameForAnyNumberOfThreadsAndNearlyForAnyInstructionSet) {
  scene::Snapshot s = test::pathView({test::backWall(), test::ballMesh(12, 1, {0, 0, 1})});
  s.settings.path.samples = 8;
  const Radiances one = radiances(s);
  s.settings.threads = 4;
  const Radiances four = radiances(s);
  EXPECT_EQ(one.traced.image.wideColor, four.traced.image.wideColor);
  test::withEachTarget([&](int64_t) { EXPECT_NEAR(radiances(s).mean().g, one.mean().g, 0.003f); });
}

TEST(Path, PassesContinueOneSequence) {
  scene::Snapshot s = test::pathView({test::backWall(), test::ballMesh(12, 1, {0, 0, 1})});
  s.settings.path.samples = 32;
  const Radiances all = radiances(s);
  s.settings.path.samples = 16;
  const Radiances first = radiances(s);
  s.lightSampling.pass = 1;
  const Radiances second = radiances(s);
  for (int y = 0; y < test::kPathSize; ++y)
    for (int x = 0; x < test::kPathSize; ++x)
      if (all.hit(x, y)) {
        ASSERT_NEAR(all.at(x, y).g, 0.5f * (first.at(x, y).g + second.at(x, y).g), 1e-4f);
      }
}

TEST(Path, OfScenesOfAnySizeHoweverTheWorldIsScaled) {
  const auto imageOf = [](double size, const glm::dvec3& scale) {
    const auto piece = [&](glm::vec3 c, glm::vec3 a, glm::vec3 b) {
      const glm::vec3 by(size / scale);
      return test::parallelogram(c * by, a * by, b * by);
    };
    scene::Snapshot s =
        test::pathView({piece({0, 0, 0}, {50, 0, 0}, {0, 50, 0}), piece({0.5f, 0, 1}, {0, 50, 0}, {0, 0, 1}),
                        piece({-0.5f, 0, 1}, {0, 50, 0}, {0, 0, 1})});
    s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1 * size, 1000.0 * size);
    s.eyeFromWorld = glm::scale(glm::translate(glm::dmat4(1), {0, 0, -5 * size}), scale);
    for (scene::Instance& instance : s.instances) {
      instance.eyeFromObject = s.eyeFromWorld;
      test::setAlbedo(instance, glm::vec3(0.8f));
    }
    s.settings.path.samples = 64;
    s.shadings[0].normalize = true;
    s.shadings[0].lights = {lightAt({0, 0, 1, 0}, glm::vec3(1))};
    return radiances(s).mean().g;
  };
  const float plain = imageOf(1, glm::dvec3(1));
  EXPECT_TRUE(std::isfinite(plain));
  for (const double size : {1e-6, 1e-3, 1e3, 1e6})
    EXPECT_NEAR(plain, imageOf(size, glm::dvec3(1)), 0.004f) << size;
  for (const glm::dvec3& scale : {glm::dvec3(1, 1, 10), glm::dvec3(100, 1, 0.01)})
    EXPECT_NEAR(plain, imageOf(1, scale), 0.004f);
}

}  // namespace
}  // namespace gluray::render
